// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/report/sample_table.h"

#include "core/base/number_text.h"
#include "ui/common/status_text.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QTableWidget>

namespace hexapose {

namespace {

struct SampleTable {
    Q_DECLARE_TR_FUNCTIONS(hexapose::SampleTable)
};

constexpr int kTarget = 1;
constexpr int kError = 7;
constexpr int kStatus = 13;
constexpr int kColumns = 14;

void put(QTableWidget& table, int row, int column, const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment((column == kStatus ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    table.setItem(row, column, item);
}

void putCoordinates(QTableWidget& table, int row, int column, const PoseVector& si, int decimals) {
    for (int i = 0; i < 6; ++i) {
        put(table, row, column + i, QString::fromStdString(formatFixed(toDisplay(i, si[i]), decimals)));
    }
}

} // namespace

void prepareSampleTable(QTableWidget& table) {
    table.setColumnCount(kColumns);
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.verticalHeader()->hide();
    table.verticalHeader()->setDefaultSectionSize(24);
    table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table.horizontalHeader()->setStretchLastSection(true);
    table.horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table.horizontalHeader()->setHighlightSections(false);
    table.setShowGrid(false);
}

void nameSampleColumns(QTableWidget& table) {
    QStringList heads{SampleTable::tr("No.")};
    for (const CoordinateText& text : coordinateTexts()) {
        heads << text.symbol + QStringLiteral(", ") + text.unit;
    }
    for (const CoordinateText& text : coordinateTexts()) {
        heads << QString::fromUtf8("\u0394") + text.symbol + QStringLiteral(", ") + text.unit;
    }
    table.setHorizontalHeaderLabels(heads << SampleTable::tr("Solution"));
    table.horizontalHeaderItem(kStatus)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void fillSampleTable(QTableWidget& table, const ErrorReport& report) {
    const auto samples = static_cast<int>(report.rows.size());
    table.setRowCount(samples == 0 ? 0 : samples + 3);
    for (int r = 0; r < samples; ++r) {
        const ErrorRow& row = report.rows[static_cast<std::size_t>(r)];
        put(table, r, 0, QString::number(row.number));
        putCoordinates(table, r, kTarget, row.sample.target.toVector(), 2);
        if (row.solution.isUsable()) {
            putCoordinates(table, r, kError, row.error, 4);
        } else {
            for (int i = 0; i < 6; ++i) {
                put(table, r, kError + i, QStringLiteral("--"));
            }
        }
        put(table, r, kStatus, solveStatusText(row.solution.status));
    }
    if (samples == 0) {
        return;
    }
    const std::pair<QString, const PoseVector*> feet[] = {
        {SampleTable::tr("mean"), &report.statistics.mean},
        {SampleTable::tr("RMS"), &report.statistics.rms},
        {SampleTable::tr("largest"), &report.statistics.maximum}};
    int r = samples;
    for (const auto& [text, values] : feet) {
        for (int column = 0; column < kColumns; ++column) {
            put(table, r, column, QString());
        }
        put(table, r, 0, text);
        putCoordinates(table, r, kError, *values, 4);
        ++r;
    }
    table.scrollToItem(table.item(samples - 1, 0));
}

} // namespace hexapose
