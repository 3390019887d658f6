// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/path_fallback.h"

#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/solver_checks.h"

#include <utility>

namespace hexapose {

namespace {

/// Distances of poses are offsets over the machine's size plus angles, changes of the lengths over its size.
/// A pose nearer to the start than this is one that the legs led to.
constexpr double kNear = 0.02;
/// The legs change by a tenth of the distance at least, wherever a path led from pose to pose (0.08 in tens
/// of thousands of poses within 150 mm and 120 deg on three machines); by a thirtieth at most where Newton's
/// iteration went to another pose of nearly the same lengths.
constexpr double kLeastLegChange = 0.05;

/// At the end of a path, which is exact to the fourth order there: from a coarse one two are needed.
constexpr int kMostEndCorrections = 3;
/// A longer path than this, of the machine's size, is no correction any more.
constexpr double kLongestEndCorrection = 1e-3;

} // namespace

PathFallback::PathFallback(const SharedModel& model, std::shared_ptr<const ForwardSolver> solver,
                           const PathFallbackOptions& options)
    : m_model(model), m_solver(std::move(solver)), m_path(model), m_steps(*model), m_options(options),
      m_size(model->size()) {
    if (!(m_options.tolerance > 0.0))
        m_options.tolerance = defaultTolerance(model->geometry());
}

double PathFallback::distance(const Pose& a, const Pose& b) const noexcept {
    constexpr double kHalf = 0.70710678118654752; // of the norm of a matrix for a small turn
    return (a.offset - b.offset).norm() / m_size +
           kHalf * (rotationMatrix(a.angles) - rotationMatrix(b.angles)).norm();
}

bool PathFallback::isUnsure(const ForwardResult& result, const LegLengths& lengths,
                            const Pose& start) const noexcept {
    if (result.isUsable()) {
        // At most this far; in a control cycle that is all there is to ask.
        const PoseVector change = (result.pose.toVector() - start.toVector()).cwiseAbs();
        if (change.head<3>().sum() / m_size + change.tail<3>().sum() <= kNear)
            return false;
        const double far = distance(start, result.pose);
        return far > kNear && (lengths - m_model->actuators(start)).norm() < kLeastLegChange * far * m_size;
    }
    return result.status == SolveStatus::OtherBranch || result.status == SolveStatus::Singular ||
           (result.status == SolveStatus::IterationLimit && m_options.afterIterationLimit);
}

PathFallback::Answer PathFallback::answer(const LegLengths& lengths, const Pose& start) const noexcept {
    Answer answer{m_solver->solve(lengths, start), std::nullopt, false};
    if (!isUnsure(answer.result, lengths, start))
        return answer;
    answer.path = m_path.followStraight(start, lengths, m_options.steps, StepForm::Corrected);
    std::optional<ForwardResult> found;
    if (answer.path->end == PathEnd::Reached)
        found = corrected(lengths, *answer.path);
    if (found && answer.result.isUsable() && distance(found->pose, answer.result.pose) < kNear)
        return answer; // confirmed
    if (found) {
        found->iterations += answer.result.iterations;
        answer.result = *found;
        answer.fromPath = true;
    } else if (answer.result.isUsable()) {
        answer.result.status = SolveStatus::OtherBranch;
    }
    return answer;
}

std::optional<ForwardResult> PathFallback::corrected(const LegLengths& lengths,
                                                     const PathResult& path) const noexcept {
    const HexapodSteps::Marks end = m_steps.marksAt(path.pose);
    HexapodSteps::Marks marks = end;
    Pose pose = path.pose;
    double residual = legResidual(m_model->geometry(), lengths, pose);
    int corrections = 0;
    while (!(residual <= m_options.tolerance)) {
        if (corrections++ == kMostEndCorrections || !(m_steps.rigidStep(marks, lengths) > 0.0) ||
            !((marks - end).norm() <= kLongestEndCorrection * m_size))
            return std::nullopt;
        pose = m_steps.poseOf(marks);
        residual = legResidual(m_model->geometry(), lengths, pose);
    }
    return ForwardResult{pose, SolveStatus::Converged, path.step + corrections, residual, true};
}

std::shared_ptr<const ForwardSolver> withPathFallback(const ForwardMethod& method, const SharedModel& model,
                                                      std::shared_ptr<const ForwardSolver> solver,
                                                      const PathFallbackOptions& options) {
    if (!method.word.ends_with("-nr"))
        return solver;
    return std::make_shared<PathFallback>(model, std::move(solver), options);
}

} // namespace hexapose
