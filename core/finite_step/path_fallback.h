// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/hexapod_steps.h"
#include "core/finite_step/leg_path.h"
#include "core/kinematics/catalog/forward_methods.h"
#include "core/kinematics/forward_solver.h"

#include <memory>
#include <optional>
#include <utility>

namespace hexapose {

struct PathFallbackOptions {
    /// Of the path: what the time of a solution is bounded by (0.75 us each), and how near to a singular pose
    /// it goes, which is q = 1 / sqrt(steps).
    int steps = 1000;
    double tolerance = 0.0; ///< Euclidean norm of the leg errors, m; 0: that of NewtonRaphson
    /// Also where the solver ran out of iterations. Off for a caller that set that limit and wants to see it
    /// reached.
    bool afterIterationLimit = true;
};

/// Another solver, and where that one is not sure of its branch, finite-step integration from `start`: the
/// pose is followed while the legs go straight from their lengths at `start` to those asked for. Not sure is
/// - a usable pose so far from `start` that the legs, which hardly moved, cannot have led there;
/// - OtherBranch: a pose of these lengths, by no known path joined to home or `start`;
/// - Singular: a pose that these lengths do not distinguish from its neighbours;
/// - IterationLimit.
/// Not NoSolution: nothing was found from anywhere, and a path would end before a pose that is not there.
///
/// A pose from the path is Converged: the path was gone to its end, by the stop rule (stop_rule.h) with q > 0
/// all along, and the pose has these lengths to the tolerance. Where the path stops, or `start` is on the
/// other side itself, the solver's answer stands, but a far pose becomes OtherBranch; answer() reports where
/// it stopped. Iterations are the solver's, the steps, and the corrections at the end.
class PathFallback final : public ForwardSolver {
public:
    /// What was found, and how.
    struct Answer {
        ForwardResult result;
        std::optional<PathResult> path; ///< nothing: the solver was sure
        bool fromPath = false;          ///< `result` is the end of the path, and not the solver's
    };

    /// Throws InputError when no three platform joints span a triangle.
    PathFallback(const SharedModel& model, std::shared_ptr<const ForwardSolver> solver,
                 const PathFallbackOptions& options = {});
    PathFallback(const PlatformGeometry& geometry, std::shared_ptr<const ForwardSolver> solver,
                 const PathFallbackOptions& options = {})
        : PathFallback(makeModel(geometry), std::move(solver), options) {}
    ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept override {
        return answer(lengths, start).result;
    }
    Answer answer(const LegLengths& lengths, const Pose& start) const noexcept;
    /// The solver's.
    std::string_view name() const noexcept override { return m_solver->name(); }

private:
    bool isUnsure(const ForwardResult& result, const LegLengths& lengths, const Pose& start) const noexcept;
    double distance(const Pose& a, const Pose& b) const noexcept;
    std::optional<ForwardResult> corrected(const LegLengths& lengths, const PathResult& path) const noexcept;

    SharedModel m_model;
    std::shared_ptr<const ForwardSolver> m_solver;
    LegPath m_path;
    HexapodSteps m_steps;
    PathFallbackOptions m_options;
    double m_size;
};

/// The solver of a method as programs use it: MPR-NR with its fallback, any other as it is.
std::shared_ptr<const ForwardSolver> withPathFallback(const ForwardMethod& method, const SharedModel& model,
                                                      std::shared_ptr<const ForwardSolver> solver,
                                                      const PathFallbackOptions& options = {});

} // namespace hexapose
