// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/leg_path.h"

#include "core/finite_step/stop_rule.h"
#include "core/kinematics/solver_checks.h"

#include <algorithm>

namespace hexapose {

namespace {

PathResult nothing() noexcept {
    PathResult result;
    result.pose = Pose::fromVector(PoseVector::Constant(kNoNumber));
    result.q = result.leastQ = result.smallestSingularValue = kNoNumber;
    return result;
}

} // namespace

LegPath::LegPath(SharedModel model) : m_model(std::move(model)), m_steps(*m_model) {}

template <class LegsAt>
PathResult LegPath::follow(const Pose& start, int steps, StepForm form, const LegsAt& legsAt) const noexcept {
    HexapodSteps::Marks marks = m_steps.marksAt(start), before = marks;
    PathResult result;
    const auto ended = [&](PathEnd end) {
        result.end = end;
        result.pose = m_steps.poseOf(marks);
        result.smallestSingularValue =
            result.pose.isFinite() ? m_model->singularity(result.pose).smallestSingularValue : 0.0;
        return result;
    };
    if (!m_steps.isRegularAtHome())
        return ended(PathEnd::Singular);
    LegLengths from = m_model->actuators(start);
    result.q = result.leastQ = m_steps.determinantRatio(marks);
    StopRule rule(steps, result.q);
    const StepSide side = form == StepForm::Open ? StepSide::Drive : StepSide::Closed;
    // One turn more than there are steps: the last pose is looked at too.
    for (; result.step <= steps; ++result.step) {
        const bool last = result.step == steps;
        const LegLengths to = last ? from : legsAt(result.step);
        HexapodSteps::Marks next = marks;
        const double q = last                          ? m_steps.determinantRatio(marks)
                         : form == StepForm::Corrected ? m_steps.rigidStep(next, to)
                                                       : m_steps.step(next, from, to, side);
        if (rule.stops(q)) {
            if (!(q > 0.0) && result.step > 0) { // already past it
                marks = before;
                --result.step;
            } else {
                result.q = q;
            }
            return ended(PathEnd::Singular);
        }
        result.q = q;
        result.leastQ = std::min(result.leastQ, q);
        if (last)
            break;
        if (form == StepForm::Corrected)
            m_steps.rigidStep(next, to);
        before = marks;
        marks = next;
        from = to;
    }
    return ended(PathEnd::Reached);
}

PathResult LegPath::followStraight(const Pose& start, const LegLengths& target, int steps,
                                   StepForm form) const noexcept {
    if (!areValidLengths(target) || !start.isFinite() || steps < 1)
        return nothing();
    const LegLengths first = m_model->actuators(start);
    const LegLengths part = (target - first) / static_cast<double>(steps);
    return follow(start, steps, form, [&](int step) -> LegLengths {
        if (step + 1 == steps)
            return target;
        return first + (step + 1.0) * part;
    });
}

PathResult LegPath::followTable(const Pose& start, std::span<const LegLengths> table,
                                StepForm form) const noexcept {
    if (!start.isFinite() || table.empty() || !std::all_of(table.begin(), table.end(), areValidLengths))
        return nothing();
    return follow(start, static_cast<int>(table.size()), form,
                  [&](int step) -> const LegLengths& { return table[static_cast<std::size_t>(step)]; });
}

} // namespace hexapose
