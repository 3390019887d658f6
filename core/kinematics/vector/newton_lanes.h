// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/pose.h"

#include <array>
#include <cstddef>

namespace hexapose {

/// Part of the solvers' inside, as all in this header. What the vector code knows of a machine: plain
/// numbers, lengths in machine sizes and from the centroid of the base joints, legs in the order of
/// elimination. The legs are split in two triples; the first is the one whose leg vectors at home span the
/// largest volume, so that their 3x3 block can be inverted without a search for pivots.
struct LaneMachine {
    /// Two triples of numbers, the last of each twice: see placeInMemory().
    using Triples = std::array<double, 8>;
    std::array<int, kLegCount> order{}; ///< place -> leg
    std::array<Triples, 3> base{}, joint{};
    Triples homeLength{};
    std::array<Triples, kLegCount> homeInverse{}; ///< of the Jacobian at home, a column each
    std::array<double, 3> baseCentroid{}; ///< from the base's origin; all else of the base is from there
    std::array<double, 3> homeOrigin{};   ///< platform origin at home
    std::array<double, 3> centroidInP{};  ///< of the platform joints, platform frame
    double size = 1.0;                    ///< m
    double spread = 1.0;
    double determinantScale =
        0.0; ///< from the product of both blocks to det J; has home's sign, so > 0 is home's side
    double homeDeterminant = 0.0; ///< that product at home
    /// Within this box about home, m and rad, who finds at least this |det J| is joined to home by
    /// a straight path on one side of the singular surface; rays through the box were looked at beforehand.
    double offsetBox = 0.0, angleBox = 0.0;
    double leastDeterminant = 0.0; ///< of the Jacobian, without sign
    double determinantSlope = 0.0; ///< most that it changed on those rays, over the norm of the step
};

/// Each triple has four places: a single solution takes its legs side by side, and lanes come in fours.
constexpr std::size_t placeInMemory(std::size_t place) {
    return place + place / 3;
}

/// Where plain Newton steps led. What is not `solved` needs another path; what is not `certified` too: the
/// pose is outside the box, near gimbal lock, or its side is not certain.
struct LaneSolution {
    Pose pose;
    std::array<double, 3> centroid; ///< machine sizes; only of what is not certified, as the next
    std::array<double, 4> rotation; ///< w x y z, not of unit length
    double residual;                ///< m; see kLooseResidual
    double startResidual;           ///< at the start, m; the same
    int iterations;
    bool solved;
    bool certified;
};

/// Residuals of the vector code are of (l^2 - |d|^2) / 2l, which needs no root. Up to this part of the
/// machine's size that is l - |d| to a part of 1e-4; larger ones are from half to many times as large.
constexpr double kLooseResidual = 1e-4;

/// Newton (Eq. 14) from one start, full steps. lengths and tolerance: m. start: finite; home when it is all
/// zeros.
void solveLane(const LaneMachine& machine, const LegLengths& lengths, const Pose& start, double tolerance,
               int maxIterations, LaneSolution& solution) noexcept;

/// The same from home for several lengths at once, one in each lane of the processor's vectors.
struct LaneBlock {
    static constexpr std::size_t kMostLanes = 8;
    using Lanes = std::array<double, kMostLanes>;
    alignas(64) std::array<Lanes, 6> pose;
    alignas(64) Lanes residual, iterations;
    std::array<bool, kMostLanes> certified; ///< solved and certain
};
/// How many at once on this processor.
std::size_t laneCount() noexcept;
/// lengths: `count` rows from the pointer on. blocks: laneCount() rows go to each, the rest to the last one.
void solveLanes(const LaneMachine& machine, const LegLengths* lengths, std::size_t count, double tolerance,
                int maxIterations, LaneBlock* blocks) noexcept;

/// Determinants of the Jacobian, positive on home's side, at `count` poses evenly spaced on the ray from home
/// to `end`, which is the last. Its angles: up to 1.6 rad.
void laneDeterminants(const LaneMachine& machine, const PoseVector& end, std::size_t count,
                      double* values) noexcept;

} // namespace hexapose
