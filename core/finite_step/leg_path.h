// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/hexapod_steps.h"
#include "core/finite_step/step_form.h"
#include "core/kinematics/platform_model.h"

#include <cstdint>
#include <span>

namespace hexapose {

/// How the following of a path ended.
enum class PathEnd : std::uint8_t {
    Reached,     ///< the end of the path
    Singular,    ///< stopped before a singular pose
    InvalidInput ///< a length or the pose is none, or no steps are asked for
};

/// What is known at the end of a path, or where it stopped. The pose is connected to the one it began with.
struct PathResult {
    PathEnd end = PathEnd::InvalidInput;
    Pose pose;           ///< by best rigid fit; angles in the ranges of eulerAngles(); NaN for InvalidInput
    double q = 0.0;      ///< there: determinant of the step matrix over that at home, signed
    double leastQ = 0.0; ///< along the path
    int step = 0;        ///< steps done
    double smallestSingularValue = 0.0; ///< there, see singularity.h
};

/// Finite-step integration of a 6-UPS platform (Front. Mech. Eng. 2025, 20(1):7, Algorithm 1): follows the
/// pose while the legs move. Immutable; allocates nothing after construction.
class LegPath {
public:
    /// Throws InputError when no three platform joints span a triangle.
    explicit LegPath(SharedModel model);
    explicit LegPath(const PlatformGeometry& geometry) : LegPath(makeModel(geometry)) {}

    /// All legs straight from their lengths at `start` to `target` (m), in equal parts.
    PathResult followStraight(const Pose& start, const LegLengths& target, int steps,
                              StepForm form) const noexcept;
    /// Through the lengths of a table, one step a row; the first row is the next after `start`.
    PathResult followTable(const Pose& start, std::span<const LegLengths> table,
                           StepForm form) const noexcept;

private:
    template <class LegsAt>
    PathResult follow(const Pose& start, int steps, StepForm form, const LegsAt& legsAt) const noexcept;

    SharedModel m_model;
    HexapodSteps m_steps;
};

} // namespace hexapose
