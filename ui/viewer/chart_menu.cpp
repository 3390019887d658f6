// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/chart_sheet.h"

#include <QMenu>

#include <algorithm>

// The menu of a chart; chart_sheet.cpp is what its page does.
namespace hexapose {

void ChartSheet::showMenu(LogChart& chart, QPoint position) {
    const Entry* entry = find(&chart);
    if (entry == nullptr)
        return;
    const auto index = static_cast<std::size_t>(entry - m_charts.data());
    const ChartSpec spec = entry->spec;
    const double place = cursorPlace();
    QMenu menu(this);
    QMenu* add = menu.addMenu(tr("Add curve"));
    for (const Column& column : table()->columns()) {
        const CurveSpec curve{QString::fromStdString(column.info().name), {}};
        if (column.isNumber() &&
            std::find(spec.curves.begin(), spec.curves.end(), curve) == spec.curves.end())
            add->addAction(curve.name(), this, [this, index, curve] { addCurve(index, curve); });
    }
    add->setEnabled(!add->isEmpty());
    QMenu* remove = menu.addMenu(tr("Remove curve"));
    for (const CurveSpec& curve : spec.curves)
        remove->addAction(curve.name(), this, [this, index, curve] { removeCurve(index, curve); });
    remove->setEnabled(!remove->isEmpty());
    menu.addSeparator();
    menu.addAction(tr("Add chart"), this, [this] { addChart({}); });
    menu.addAction(tr("Remove chart"), this, [this, index] { removeChart(index); })
        ->setEnabled(m_charts.size() > 1);
    menu.addAction(tr("Export this chart..."), this, [this, spec] { emit exportRequested(spec); });
    menu.addSeparator();
    menu.addAction(tr("Cursor A here"), this, [this, place] { setCursor('a', place); });
    menu.addAction(tr("Cursor B here"), this, [this, place] { setCursor('b', place); });
    menu.addAction(tr("Show everything"), this, [this] { fit(); });
    menu.exec(position);
}

} // namespace hexapose
