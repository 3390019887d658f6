// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewer/chart_sheet.h"
#include "ui/viewer/log_file.h"

#include <QScrollArea>

#include <optional>

namespace hexapose {

/// What is shown of a log at first.
struct FirstView {
    std::optional<ChartLayout> layout; ///< empty: that of its columns
    std::vector<std::string> charts;   ///< those of them alone, or columns; empty: all
    std::optional<double> from, to;    ///< s
};

/// One open log: its file, and its charts.
class LogPage final : public QScrollArea {
    Q_OBJECT
public:
    LogPage(const QString& path, const FirstView& first, QWidget* parent = nullptr);

    LogFile& file() { return *m_file; }
    ChartSheet& sheet() { return *m_sheet; }

signals:
    /// More was read.
    void changed();

private:
    void takeUp();
    ChartLayout firstLayout(const Table& table) const;
    void showFirstTime(const Table& table);

    FirstView m_first;
    bool m_hasLayout = false;
    bool m_hasTime = false;
    LogFile* m_file;
    ChartSheet* m_sheet;
};

} // namespace hexapose
