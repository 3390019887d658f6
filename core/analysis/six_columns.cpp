// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/analysis/six_columns.h"

#include "core/table/column_unit.h"

#include <cmath>

namespace hexapose {

namespace {

bool isAngle(std::string_view unit) {
    return unit == "deg" || unit == "rad" || unit == "mrad" || unit == "urad";
}

bool isLength(std::string_view unit) {
    return unit == "m" || unit == "mm" || unit == "cm" || unit == "um" || unit == "nm" || unit == "in";
}

std::optional<SixColumns> find(const Table& table, const std::array<const char*, 6>& labels,
                               std::size_t lengths) {
    SixColumns found;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const auto column = table.find(labels[i]);
        if (!column || !table.columns()[*column].isNumber())
            return std::nullopt;
        std::string unit = table.columns()[*column].info().unit;
        if (unit.empty())
            unit = i < lengths ? "mm" : "deg";
        if (i < lengths ? !isLength(unit) : !isAngle(unit))
            return std::nullopt;
        found.columns[i] = *column;
        found.toSi[i] = *toSi(unit);
    }
    return found;
}

std::optional<Eigen::Matrix<double, 6, 1>> sixOf(const Table& table, const SixColumns& columns, Row row) {
    Eigen::Matrix<double, 6, 1> values;
    for (std::size_t i = 0; i < columns.columns.size(); ++i) {
        const double value = table.columns()[columns.columns[i]].number(row);
        if (std::isnan(value))
            return std::nullopt;
        values[static_cast<Eigen::Index>(i)] = value * columns.toSi[i];
    }
    return values;
}

} // namespace

std::optional<SixColumns> findLengths(const Table& table) {
    return find(table, {"l1", "l2", "l3", "l4", "l5", "l6"}, 6);
}

std::optional<SixColumns> findMeasuredPose(const Table& table) {
    return find(table, {"x", "y", "z", "alpha", "beta", "gamma"}, 3);
}

std::optional<LegLengths> lengthsOf(const Table& table, const SixColumns& columns, Row row) {
    return sixOf(table, columns, row);
}

std::optional<Pose> poseOf(const Table& table, const SixColumns& columns, Row row) {
    const auto values = sixOf(table, columns, row);
    return values ? std::optional(Pose::fromVector(*values)) : std::nullopt;
}

} // namespace hexapose
