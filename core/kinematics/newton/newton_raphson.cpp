// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/newton/newton_raphson.h"

#include "core/base/units.h"
#include "core/kinematics/newton/home_side.h"
#include "core/kinematics/pose_samples.h"
#include "core/kinematics/solver_checks.h"
#include "core/kinematics/vector/lane_machine.h"
#include "core/kinematics/vector/parallel_lanes.h"

#include <algorithm>
#include <array>
#include <thread>
#include <utility>

namespace hexapose {

namespace {

/// 1e-10 m over the 0.2999165 m of the laboratory platform.
constexpr double kRelativeTolerance = 1e-10 / 0.2999165;

/// A start turned further than this is no ordinary one.
constexpr double kMostAngle = 1000.0;
/// Where else to look for a pose before saying that there is none: home, home turned about each axis, and so
/// many places drawn from a box about it, in machine sizes and radians. Without the last, 2 % of the poses
/// within 0.4 sizes and 110 deg were not found, on three machines; with 16 of them all of tens of thousands,
/// or another pose of their lengths.
constexpr double kTurn = radiansFromDeg(60.0);
constexpr int kTurns = 6, kDrawn = 24;
constexpr double kDrawnOffset = 0.3, kDrawnAngle = 2.0;
constexpr std::uint64_t kDrawnSeed = 1;
/// An array shorter than this is done before another thread has started.
constexpr std::size_t kRowsWorthAThread = 2000;
/// So much of a batch that its results stay in the first cache until they are handed out.
constexpr std::size_t kBlocksAtATime = 16;

/// Sign of the Jacobian's determinant at the end of a run; 0 where the pose is singular. Most runs end with a
/// step so short that the factorisation before it decides.
double branchSign(const LegEquations& equations, const NewtonRun& run) noexcept {
    const double margin = singularValueBound(run.determinant);
    if (2.0 * equations.jacobianChange(run.evaluation, run.lastStepNorm) < margin &&
        margin > 2.0 * kSingularValueFloor)
        return std::copysign(1.0, run.determinant);
    return equations.branchSign(run.evaluation, kSingularValueFloor);
}

SolveStatus statusOf(NewtonEnd end) noexcept {
    switch (end) {
    case NewtonEnd::Solved:
        return SolveStatus::Converged;
    case NewtonEnd::Stationary:
        return SolveStatus::NoSolution;
    case NewtonEnd::Limit:
        break;
    }
    return SolveStatus::IterationLimit;
}

} // namespace

double defaultTolerance(const PlatformGeometry& geometry) {
    return kRelativeTolerance * geometry.size();
}

NewtonRaphson::NewtonRaphson(SharedModel model, const NewtonOptions& options)
    : m_model(std::move(model)),
      m_tolerance(options.tolerance > 0.0 ? options.tolerance : defaultTolerance(m_model->geometry())),
      m_maxIterations(options.maxIterations), m_homeDeterminant(m_model->homeDeterminant()),
      m_lanes(makeLaneMachine(equations(), m_homeDeterminant)) {}

ForwardResult NewtonRaphson::solve(const LegLengths& lengths, const Pose& start) const noexcept {
    double unused = 0.0;
    return solve(lengths, start, unused);
}

ForwardResult NewtonRaphson::solve(const LegLengths& lengths, const Pose& start,
                                   double& startResidual) const noexcept {
    startResidual = std::numeric_limits<double>::infinity();
    const auto ordinary = [](double angle) { return std::abs(angle) <= kMostAngle; };
    if (m_homeDeterminant == 0.0 || !ordinary(start.angles.alpha) || !ordinary(start.angles.beta) ||
        !ordinary(start.angles.gamma))
        return solveCarefully(lengths, start);
    LaneSolution found;
    solveLane(m_lanes, lengths, start, m_tolerance, m_maxIterations, found);
    startResidual = found.startResidual;
    if (!found.solved || found.residual > kLooseResidual * m_lanes.size)
        return solveCarefully(lengths, start);
    if (found.certified)
        return {found.pose, SolveStatus::Converged, found.iterations, found.residual, true};
    NewtonRun run;
    const Eigen::Vector4d q = Eigen::Vector4d::Map(found.rotation.data()).normalized();
    run.placement = {Eigen::Vector3d::Map(found.centroid.data()), q[0], q.tail<3>()};
    const LegEquations::Legs target = equations().scaled(lengths);
    run.evaluation = equations().evaluate(run.placement, target);
    run.evaluation.residual = found.residual / equations().size();
    run.end = NewtonEnd::Solved;
    return verified(run, found.iterations, equations().placementOf(start), target);
}

ForwardResult NewtonRaphson::solveCarefully(const LegLengths& lengths, const Pose& start) const noexcept {
    if (!areValidLengths(lengths) || !start.isFinite())
        return failure(SolveStatus::InvalidInput, 0, kNoNumber);
    const LegEquations::Legs target = equations().scaled(lengths);
    const double tolerance = m_tolerance / equations().size();
    if (equations().areUnreachable(target, tolerance))
        return failure(SolveStatus::NoSolution, 0, kNoNumber);
    const Placement from = equations().placementOf(start);
    if (m_homeDeterminant == 0.0) {
        const double residual = equations().evaluate(from, target).residual * equations().size();
        return {normalised(start), SolveStatus::Singular, 0, residual, residual <= m_tolerance};
    }

    const auto attempt = [&](const Placement& place, StepGuard guard) {
        return runNewton(equations(), target, place, tolerance, m_maxIterations, guard);
    };
    NewtonRun run = attempt(from, StepGuard::Shorten);
    int iterations = run.iterations;
    if (run.end == NewtonEnd::Stationary) {
        // That no pose has these lengths is much to say; it must hold for the other step rule and from other
        // places too.
        const auto takes = [&](const Placement& place, StepGuard guard) {
            const NewtonRun other = attempt(place, guard);
            iterations += other.iterations;
            if (other.end == NewtonEnd::Solved)
                run = other;
            return other.end == NewtonEnd::Solved;
        };
        bool found = takes(from, StepGuard::None);
        PoseSamples drawn(kDrawnOffset * equations().size(), kDrawnAngle, kDrawnSeed, 0);
        for (int i = 0; i <= kTurns + kDrawn && !found; ++i) {
            PoseVector other = PoseVector::Zero();
            if (i > kTurns)
                other = drawn.next().toVector();
            else if (i > 0)
                other[3 + (i - 1) / 2] = i % 2 == 1 ? kTurn : -kTurn;
            const Placement place = equations().placementOf(Pose::fromVector(other));
            found = takes(place, StepGuard::Shorten) || takes(place, StepGuard::None);
        }
    }
    return verified(run, iterations, from, target);
}

bool NewtonRaphson::isNear(const Pose& pose, double ratio) const noexcept {
    const PoseVector at = pose.toVector().cwiseAbs();
    return ratio * std::abs(m_homeDeterminant) > m_lanes.leastDeterminant &&
           at.head<3>().maxCoeff() <= m_lanes.offsetBox && at.tail<3>().maxCoeff() <= m_lanes.angleBox;
}

ForwardResult NewtonRaphson::verified(const NewtonRun& run, int iterations, const Placement& start,
                                      const LegEquations::Legs& target) const noexcept {
    const double residual = run.evaluation.residual * equations().size();
    ForwardResult result{equations().poseOf(run.placement), statusOf(run.end), iterations, residual,
                         run.end == NewtonEnd::Solved};
    if (run.end == NewtonEnd::Limit)
        return result;
    const HomeSide side(equations(), m_homeDeterminant);
    const Placement home = equations().placementOf(Pose{});
    const bool startOnSide = side.determinantRatio(start) > 0.0;
    if (run.end == NewtonEnd::Solved) {
        const double sign = branchSign(equations(), run);
        result.status = branchStatus(sign, m_homeDeterminant);
        if (result.status == SolveStatus::Singular)
            return result;
        if (result.status == SolveStatus::Converged &&
            (isNear(result.pose, side.determinantRatio(run.placement)) ||
             (startOnSide && side.isConnected(start, run.placement)) ||
             side.isConnected(home, run.placement)))
            return result;
        result.status = SolveStatus::OtherBranch;
    }
    if (!startOnSide) // who starts there asks about that side
        return result.status == SolveStatus::NoSolution
                   ? failure(SolveStatus::NoSolution, iterations, residual)
                   : result;
    for (const Placement* from : {&start, &home}) {
        const auto end = side.follow(*from, target, m_tolerance / equations().size(), result.iterations);
        if (!end)
            continue;
        const double left = equations().evaluate(*end, target).residual * equations().size();
        return {equations().poseOf(*end), SolveStatus::Converged, result.iterations, left, true};
    }
    if (result.status == SolveStatus::NoSolution)
        return failure(SolveStatus::NoSolution, result.iterations, residual);
    return result;
}

void NewtonRaphson::solveRange(std::span<const LegLengths> lengths,
                               std::span<ForwardResult> results) const noexcept {
    const std::size_t lanes = laneCount();
    std::array<LaneBlock, kBlocksAtATime> blocks;
    for (std::size_t first = 0; first < lengths.size(); first += lanes * blocks.size()) {
        const std::size_t count = std::min(lanes * blocks.size(), lengths.size() - first);
        solveLanes(m_lanes, lengths.data() + first, count, m_tolerance, m_maxIterations, blocks.data());
        for (std::size_t row = 0; row < count; row += lanes) {
            const std::size_t here = first + row, rows = std::min(lanes, count - row);
            unpack(blocks[row / lanes], lengths.subspan(here, rows), results.subspan(here, rows));
        }
    }
}

void NewtonRaphson::unpack(const LaneBlock& block, std::span<const LegLengths> lengths,
                           std::span<ForwardResult> results) const noexcept {
    const double loose = kLooseResidual * m_lanes.size;
    for (std::size_t i = 0; i < results.size(); ++i) {
        ForwardResult& result = results[i];
        if (!block.certified[i] || block.residual[i] > loose) {
            result = solve(lengths[i], Pose{});
            continue;
        }
        result.pose.offset = {block.pose[0][i], block.pose[1][i], block.pose[2][i]};
        result.pose.angles = {block.pose[3][i], block.pose[4][i], block.pose[5][i]};
        result.status = SolveStatus::Converged;
        result.iterations = static_cast<int>(block.iterations[i]);
        result.residual = block.residual[i];
        result.accurate = true;
    }
}

void NewtonRaphson::solveAll(std::span<const LegLengths> lengths, std::span<ForwardResult> results,
                             unsigned threads) const {
    if (threads == 0)
        threads = std::max(1U, std::thread::hardware_concurrency());
    const auto useful = static_cast<unsigned>(
        std::min<std::size_t>(threads, std::max<std::size_t>(1, lengths.size() / kRowsWorthAThread)));
    if (useful == 1) {
        solveRange(lengths, results);
        return;
    }
    const std::size_t part = (lengths.size() + useful - 1) / useful;
    runLanes(
        static_cast<int>(useful), useful,
        [&](int lane) {
            const std::size_t first = std::min(lengths.size(), part * static_cast<std::size_t>(lane));
            const std::size_t count = std::min(part, lengths.size() - first);
            solveRange(lengths.subspan(first, count), results.subspan(first, count));
        },
        [] {});
}

} // namespace hexapose
