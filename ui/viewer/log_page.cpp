// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/log_page.h"

#include "core/base/input_error.h"

namespace hexapose {

LogPage::LogPage(const QString& path, const FirstView& first, QWidget* parent)
    : QScrollArea(parent), m_first(first), m_hasTime(!first.from && !first.to),
      m_file(new LogFile(path, this)), m_sheet(new ChartSheet(this)) {
    setWidget(m_sheet);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(m_file, &LogFile::changed, this, &LogPage::takeUp);
    takeUp();
}

void LogPage::takeUp() {
    const std::shared_ptr<const Table> table = m_file->table();
    m_sheet->setTable(table);
    if (!m_hasLayout && !table->columns().empty()) {
        m_hasLayout = true;
        m_sheet->setChartLayout(firstLayout(*table));
    }
    if (!m_hasTime)
        showFirstTime(*table);
    emit changed();
}

ChartLayout LogPage::firstLayout(const Table& table) const {
    const ChartLayout layout = m_first.layout ? *m_first.layout : defaultLayout(table);
    if (m_first.charts.empty())
        return layout;
    try {
        return chosenCharts(layout, table, m_first.charts);
    } catch (const InputError&) { // another log has them
        return layout;
    }
}

/// As soon as it has been read, or there is no more.
void LogPage::showFirstTime(const Table& table) {
    const bool isDone = m_file->progress().isDone;
    if (table.rowCount() == 0 || (!isDone && !(m_first.to && table.time().end() >= *m_first.to)))
        return;
    m_hasTime = true;
    m_sheet->showTime({m_first.from.value_or(table.time().begin()), m_first.to.value_or(table.time().end())});
}

} // namespace hexapose

#include "moc_log_page.cpp"
