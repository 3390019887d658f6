// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/pose.h"
#include "core/table/table.h"

#include <array>
#include <optional>
#include <string>

namespace hexapose {

/// Six columns of a table that belong together: the lengths, or the coordinates of a pose.
struct SixColumns {
    std::array<std::size_t, 6> columns{};
    std::array<double, 6> toSi{}; ///< what a cell is multiplied by to be in m or rad
};

/// l1 to l6, by their names without unit; of the unit that each has, mm where it has none. Nothing where one
/// is missing or has a unit that is no length.
std::optional<SixColumns> findLengths(const Table& table);
/// x, y, z, alpha, beta, gamma likewise; angles in deg where they have no unit.
std::optional<SixColumns> findMeasuredPose(const Table& table);

/// Of a row; nothing where a cell is missing.
std::optional<LegLengths> lengthsOf(const Table& table, const SixColumns& columns, Row row);
std::optional<Pose> poseOf(const Table& table, const SixColumns& columns, Row row);

} // namespace hexapose
