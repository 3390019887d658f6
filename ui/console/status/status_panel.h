// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/record/snapshot.h"

#include <QWidget>

#include <string_view>

class QLabel;

namespace hexapose {

class ReadOut;

/// The line at the foot of the window: state, rate, age of the data, solver and what it said, frames dropped.
class StatusPanel final : public QWidget {
    Q_OBJECT
public:
    explicit StatusPanel(QWidget* parent = nullptr);
    void setPlatform(const QString& name);
    void setSolver(std::string_view word);
    void showSnapshot(const Snapshot& snapshot);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Item {
        QLabel* label;
        ReadOut* value;
        QLabel* unit;
    };
    Item makeItem(const QString& unit, int digits);
    void retranslate();

    Snapshot m_snapshot; ///< for the words, when the language changes
    QLabel* m_lamp;
    Item m_state;
    Item m_rate;
    Item m_age;
    Item m_solver;
    Item m_iterations;
    Item m_residual;
    Item m_dropped;
    Item m_platform;
};

} // namespace hexapose
