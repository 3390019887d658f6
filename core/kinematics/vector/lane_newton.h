// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Included once for each kind of vector unit.
#if defined(HEXAPOSE_LANE_NEWTON) == defined(HWY_TARGET_TOGGLE)
#ifdef HEXAPOSE_LANE_NEWTON
#undef HEXAPOSE_LANE_NEWTON
#else
#define HEXAPOSE_LANE_NEWTON
#endif

#include "core/kinematics/vector/lane_legs.h"
#include "core/kinematics/vector/lane_steps.h"

#include <hwy/highway.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace hexapose {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// From here on Newton is not going where it should, and the careful iteration takes over.
constexpr int kMostSteps = 12;
constexpr double kLeastDecrease = 0.9; // of the squared residual, in one step
/// cos(beta)^2 below which the angles want care.
constexpr double kNearGimbalLock = 1e-6;
/// The slope of the determinant was measured on rays; between them it may be this much more.
constexpr double kSlopeMargin = 2.0;

/// Newton's iteration of the poses that the steps are of: one in each lane, or a single one.
template <class Steps>
struct Newton : Steps {
    using Steps::errorAtHome, Steps::evaluate, Steps::isInBox, Steps::kOnePose, Steps::moments, Steps::move,
        Steps::rotation, Steps::set, Steps::solve, Steps::squared, Steps::stepFromHome, Steps::stepSquare,
        Steps::target;
    using D = typename Steps::Tag;
    using typename Steps::Found;
    using typename Steps::Lengths;
    using typename Steps::M;
    using typename Steps::Place;
    using typename Steps::Rotation;
    using typename Steps::Rows;
    using typename Steps::Step;
    using typename Steps::Target;
    using typename Steps::V;

    struct Limits {
        double tolerance;
        int steps;
    };

    struct Run {
        Target to;
        Place place;
        Rotation rotation; ///< of the place
        V residual2, startResidual2, determinant;
        V step2; ///< square of the norm of the step from where the determinant was taken
        V iterations;
        M solved, active;
        int steps;
    };

    /// Takes a step in the lanes that are still at work.
    static HWY_INLINE void take(const LaneMachine& machine, Step& step, Run& run) {
        if constexpr (kOnePose) {
            run.determinant = step.determinant;
            run.step2 = stepSquare(machine, step);
            run.iterations = hn::Add(run.iterations, set(1.0));
        } else {
            for (int k = 0; k < 3; ++k) {
                step.t[k] = hn::IfThenElseZero(run.active, step.t[k]);
                step.turn[1 + k] = hn::IfThenElseZero(run.active, step.turn[1 + k]);
            }
            step.turn[0] = hn::IfThenElse(run.active, step.turn[0], set(1.0));
            run.determinant = hn::IfThenElse(run.active, step.determinant, run.determinant);
            run.step2 = hn::IfThenElse(run.active, stepSquare(machine, step), run.step2);
            run.iterations = hn::Add(run.iterations, hn::IfThenElseZero(run.active, set(1.0)));
        }
        move(run.place, step);
        run.rotation = rotation(run.place.q);
        ++run.steps;
    }

    /// Place and rotation are set. fromHome: it is home, whose Jacobian was inverted beforehand. False: that
    /// is all.
    static HWY_INLINE bool begin(const LaneMachine& machine, const Lengths& lengths, bool fromHome,
                                 const Limits& limits, Run& run) {
        run.to = target(lengths);
        run.determinant = run.step2 = run.iterations = hn::Zero(D());
        run.residual2 = set(std::numeric_limits<double>::max());
        run.active = Steps::arePositive(lengths);
        run.solved = hn::Lt(run.step2, run.step2);
        run.steps = 0;
        if (!fromHome)
            return true;
        const Lengths error = errorAtHome(machine, lengths);
        run.residual2 = run.startResidual2 = squared(error);
        run.solved = hn::And(run.active, hn::Le(run.residual2, set(limits.tolerance * limits.tolerance)));
        run.active = hn::AndNot(run.solved, run.active);
        if (limits.steps <= 0 || hn::AllFalse(D(), run.active))
            return false;
        Step step = stepFromHome(machine, error);
        take(machine, step, run);
        return true;
    }

    /// The stop test, and another step. False: that is all.
    static HWY_INLINE bool advance(const LaneMachine& machine, const Limits& limits, Run& run) {
        Rows rows;
        evaluate(machine, run.place, run.rotation, run.to, rows);
        if (run.steps == 0)
            run.startResidual2 = rows.residual2;
        // Not a number is not less.
        run.active = hn::And(run.active, hn::Lt(rows.residual2, hn::Mul(run.residual2, set(kLeastDecrease))));
        run.residual2 = hn::IfThenElse(run.active, rows.residual2, run.residual2);
        const M done = hn::And(run.active, hn::Le(rows.residual2, set(limits.tolerance * limits.tolerance)));
        run.solved = hn::Or(run.solved, done);
        run.active = hn::AndNot(done, run.active);
        if (run.steps >= limits.steps || hn::AllFalse(D(), run.active))
            return false;
        moments(machine, rows);
        Step step = solve(rows, run.place);
        take(machine, step, run);
        return true;
    }

    /// Solved, surely on home's side, in the box, and with angles that can be told.
    static HWY_INLINE M clear(const LaneMachine& machine, const Run& run, const Found& found) {
        // The determinant is that before the last steps.
        const V determinant = hn::Mul(run.determinant, set(machine.determinantScale));
        const V least = hn::MulAdd(set(kSlopeMargin * machine.determinantSlope), hn::Sqrt(run.step2),
                                   set(machine.leastDeterminant));
        const M good = hn::And(run.solved, hn::Gt(determinant, hn::Mul(least, run.to.product)));
        return hn::And(hn::And(good, hn::Gt(found.cosBeta2, set(kNearGimbalLock))), isInBox(machine, found));
    }
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace hexapose
HWY_AFTER_NAMESPACE();
#endif
