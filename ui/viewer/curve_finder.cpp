// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/curve_finder.h"

#include <cmath>

namespace hexapose {

namespace {

constexpr Row kHugeRows = Row{1} << 20; ///< as many are worth huge pages

/// Angles that turned past 180 degrees are as near as they look.
double apart(double value, double from, bool isAngle) {
    const double difference = value - from;
    return isAngle ? std::remainder(difference, 360.0) : difference;
}

} // namespace

void CurveFinder::follow(const std::shared_ptr<const Table>& table) {
    if (table->rowCount() < m_table->rowCount() || table->sourceName() != m_table->sourceName())
        m_differences.clear();
    m_table = table;
}

std::shared_ptr<const Column> CurveFinder::plain(const QString& name) const {
    const auto index = m_table->find(name.toStdString());
    if (!index || !m_table->columns()[*index].isNumber())
        return nullptr;
    return {m_table, &m_table->columns()[*index]};
}

std::shared_ptr<const Column> CurveFinder::difference(const CurveSpec& spec) {
    const auto value = plain(spec.column), from = plain(spec.minus);
    if (!value || !from)
        return nullptr;
    Difference& known = m_differences[spec.name()];
    const Row rows = m_table->rowCount();
    if (known.column && known.rows == rows)
        return known.column;
    const bool isAngle = value->info().unit == "deg";
    known.numbers.reserve(rows, rows >= kHugeRows);
    for (Row row = known.rows; row < rows; ++row)
        known.numbers.writable(row / kChunkRows)[row % kChunkRows] =
            apart(value->number(row), from->number(row), isAngle);
    known.rows = rows;
    known.pyramid.grow(known.numbers, rows);
    ColumnInfo info = value->info();
    info.name = spec.name().toStdString();
    known.column = std::make_shared<const Column>(info, known.numbers, known.pyramid);
    return known.column;
}

std::optional<Curve> CurveFinder::find(const CurveSpec& spec) {
    auto column = spec.minus.isEmpty() ? plain(spec.column) : difference(spec);
    return column ? std::optional(Curve{spec, std::move(column)}) : std::nullopt;
}

std::vector<Curve> CurveFinder::find(const ChartSpec& chart) {
    std::vector<Curve> curves;
    for (const CurveSpec& spec : chart.curves)
        if (auto curve = find(spec))
            curves.push_back(std::move(*curve));
    return curves;
}

} // namespace hexapose
