// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/pose.h"

#include <optional>
#include <string_view>

namespace hexapose {

/// How a forward solution ended.
enum class SolveStatus {
    Converged,      ///< the pose of these lengths, to the tolerance, on home's side of the singular poses
    IterationLimit, ///< residual still above the tolerance after the allowed iterations
    Singular,       ///< the Jacobian cannot be inverted here
    NoSolution,     ///< no pose of these lengths was found, from anywhere
    InvalidInput,   ///< a length is NaN, infinite, zero or negative
    OutsideModel,   ///< outside what the regression was trained on (MPR-NR: solved by Newton from the start
                    ///< instead)
    OtherBranch,    ///< a pose of these lengths, but of another assembly mode than home's
};

/// "converged", "iteration-limit", ... as in the command line's contract; the inverse accepts no other words.
std::string_view toWord(SolveStatus status);
std::optional<SolveStatus> solveStatusFromWord(std::string_view word);

/// The result of a forward solution. pose: angles in the ranges of eulerAngles(); NaN where there is none.
/// residual: Euclidean norm of the six leg errors at `pose` (Eq. 3), metres; NaN where nothing was computed.
struct ForwardResult {
    Pose pose;
    SolveStatus status = SolveStatus::InvalidInput;
    int iterations = 0;
    double residual = 0.0;

    /// Whether `pose` means anything; false for InvalidInput and NoSolution, and for a
    /// regression alone outside its model.
    bool hasPose() const;
    /// Whether the pose may be shown and used as the measured pose: Converged, or OutsideModel with the
    /// residual within the tolerance that the solver was given (see `accurate`).
    bool isUsable() const {
        return status == SolveStatus::Converged || (status == SolveStatus::OutsideModel && accurate);
    }
    /// The residual is within the solver's tolerance.
    bool accurate = false;
};

/// From leg lengths to pose. Implementations are immutable after construction, allocate nothing in solve(),
/// and may be called from several threads at once.
class ForwardSolver {
public:
    virtual ~ForwardSolver() = default;
    /// lengths: leg 1 first, m. start: where iteration begins, or falls back to, m and rad (home is Pose{}).
    /// Throws nothing: lengths that are none, or a start that is not finite, are InvalidInput.
    virtual ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept = 0;
    /// The method's word on the command line: "newton", "mpr3-nr", ...
    virtual std::string_view name() const noexcept = 0;
};

} // namespace hexapose
