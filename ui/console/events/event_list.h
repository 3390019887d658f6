// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/record/event.h"
#include "ui/common/card.h"
#include "ui/console/events/event_text.h"

#include <chrono>
#include <deque>
#include <functional>

class QListWidget;
class QListWidgetItem;

namespace hexapose {

/// What happened, newest first, each with its time, its cause and what to do about it. The same thing many
/// times in a row takes one place and is counted.
class EventList final : public Card {
    Q_OBJECT
public:
    using Time = std::chrono::system_clock::time_point;
    /// Says its text anew when the language changes.
    using Text = std::function<EventText()>;

    explicit EventList(QWidget* parent = nullptr);
    void add(const Event& event, Time time);
    /// Something of the screen's own, not of the engine.
    void addNote(const Text& text, Time time);
    int count() const;
    QString textAt(int row) const; ///< row 0 is the newest

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Entry {
        Text text;
        Time time;
        int times = 1;
        std::string key; ///< equal keys are the same thing
    };
    void put(Entry entry);
    void write(QListWidgetItem& item, const Entry& entry);
    void retranslate();

    std::deque<Entry> m_entries; ///< newest first, as the rows
    QListWidget* m_list;
};

} // namespace hexapose
