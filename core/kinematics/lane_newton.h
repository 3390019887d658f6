// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Included once for each kind of vector unit.
#if defined(HEXAPOSE_LANE_NEWTON) == defined(HWY_TARGET_TOGGLE)
#ifdef HEXAPOSE_LANE_NEWTON
#undef HEXAPOSE_LANE_NEWTON
#else
#define HEXAPOSE_LANE_NEWTON
#endif

#include "core/kinematics/lane_angles.h"
#include "core/kinematics/lane_steps.h"

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

/// Newton's iteration of one pose in each lane.
template <class D>
struct Newton : LaneSteps<D> {
    using Steps = LaneSteps<D>;
    using Steps::dot3, Steps::evaluate, Steps::moments, Steps::move, Steps::rotation, Steps::set,
        Steps::solve, Steps::stepFromHome, Steps::stepSquare, Steps::target;
    using typename Steps::M;
    using typename Steps::Place;
    using typename Steps::Rotation;
    using typename Steps::Rows;
    using typename Steps::Step;
    using typename Steps::Target;
    using typename Steps::V;
    static constexpr bool kSingle = hn::MaxLanes(D()) == 1;

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

    /// evaluate() of a single pose: a leg of each triple side by side.
    static HWY_INLINE void evaluateInPairs(const LaneMachine& machine, const Run& run, Rows& rows) {
        const Target& to = run.to;
        using P = hn::Vec<Two>;
        P centroid[3], R[3][3], sum = hn::Zero(Two());
        for (int k = 0; k < 3; ++k) {
            centroid[k] = bothOf(run.place.c[k]);
            for (int j = 0; j < 3; ++j)
                R[k][j] = bothOf(run.rotation.r[k][j]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            P base[3], joint[3];
            for (std::size_t k = 0; k < 3; ++k) {
                base[k] = hn::LoadU(Two(), machine.base[k].data() + placeInMemory(i));
                joint[k] = hn::LoadU(Two(), machine.joint[k].data() + placeInMemory(i));
            }
            const auto legs = evaluateLeg(Two(), base, joint, centroid, R, pairOf(to.l2[i], to.l2[3 + i]),
                                          pairOf(to.inverse2[i], to.inverse2[3 + i]), sum);
            P m[3];
            momentOf(base, legs.d, m);
            for (std::size_t k = 0; k < 3; ++k) {
                rows.d[k][i] = firstOf(legs.d[k]);
                rows.d[k][3 + i] = secondOf(legs.d[k]);
                rows.m[k][i] = firstOf(m[k]);
                rows.m[k][3 + i] = secondOf(m[k]);
            }
            rows.e[i] = firstOf(legs.e);
            rows.e[3 + i] = secondOf(legs.e);
        }
        rows.residual2 = hn::Add(firstOf(sum), secondOf(sum));
    }

    /// Takes a step in the lanes that are still at work.
    static HWY_INLINE void take(const LaneMachine& machine, Step& step, Run& run) {
        if constexpr (kSingle) {
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
    }

    /// Place and rotation are set. fromHome: it is home, whose Jacobian was inverted beforehand. False: that
    /// is all.
    static HWY_INLINE bool begin(const LaneMachine& machine, const V* l, bool fromHome, const Limits& limits,
                                 Run& run) {
        const V zero = hn::Zero(D());
        run.to = target(l);
        run.determinant = run.step2 = run.iterations = zero;
        run.residual2 = set(std::numeric_limits<double>::max());
        run.active = hn::Gt(l[0], zero);
        for (int i = 1; i < kLegCount; ++i)
            run.active = hn::And(run.active, hn::Gt(l[i], zero));
        run.solved = hn::Lt(zero, zero);
        run.steps = 0;
        if (!fromHome)
            return true;
        V error[kLegCount];
        run.residual2 = zero;
        for (std::size_t i = 0; i < kLegCount; ++i) {
            error[i] = hn::Sub(l[i], set(machine.homeLength[i]));
            run.residual2 = hn::MulAdd(error[i], error[i], run.residual2);
        }
        run.startResidual2 = run.residual2;
        run.solved = hn::And(run.active, hn::Le(run.residual2, set(limits.tolerance * limits.tolerance)));
        run.active = hn::AndNot(run.solved, run.active);
        if (hn::AllFalse(D(), run.active))
            return false;
        Step step = stepFromHome(machine, error);
        take(machine, step, run);
        run.steps = 1;
        return true;
    }

    /// The stop test, and another step. False: that is all.
    static HWY_INLINE bool advance(const LaneMachine& machine, const Limits& limits, Run& run) {
        Rows rows;
        if constexpr (kSingle && kHasPairs)
            evaluateInPairs(unknown(machine), run, rows);
        else
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
        if constexpr (!(kSingle && kHasPairs))
            moments(machine, rows);
        Step step = solve(rows, run.place);
        take(machine, step, run);
        ++run.steps;
        return true;
    }

    static HWY_INLINE void toPose(const LaneMachine& machine, const Run& run, V* pose, V& cosBeta2) {
        const auto& r = run.rotation.r;
        for (std::size_t k = 0; k < 3; ++k) {
            const V arm = dot3(r[k][0], set(machine.centroidInP[0]), r[k][1], set(machine.centroidInP[1]),
                               r[k][2], set(machine.centroidInP[2]));
            pose[k] =
                hn::Mul(hn::Sub(hn::Sub(run.place.c[k], arm), set(machine.homeOrigin[k])), set(machine.size));
        }
        cosBeta2 = hn::MulAdd(r[0][0], r[0][0], hn::Mul(r[1][0], r[1][0]));
        pose[4] = arcTangent(D(), hn::Neg(r[2][0]), hn::Sqrt(cosBeta2));
        if constexpr (kSingle && kHasPairs) {
            const auto outer = arcTangent(Two(), pairOf(r[2][1], r[1][0]), pairOf(r[2][2], r[0][0]));
            pose[3] = firstOf(outer);
            pose[5] = secondOf(outer);
        } else {
            pose[3] = arcTangent(D(), r[2][1], r[2][2]);
            pose[5] = arcTangent(D(), r[1][0], r[0][0]);
        }
    }

    /// Solved, surely on home's side, in the box, and with angles that can be told.
    static HWY_INLINE M clear(const LaneMachine& machine, const Run& run, V cosBeta2, const V* pose) {
        // The determinant is that before the last steps.
        const V determinant =
            hn::Mul(hn::Mul(run.determinant, run.to.inverseProduct), set(machine.determinantScale));
        const V least = hn::MulAdd(set(kSlopeMargin * machine.determinantSlope), hn::Sqrt(run.step2),
                                   set(machine.leastDeterminant));
        M good = hn::And(run.solved, hn::Gt(determinant, least));
        good = hn::And(good, hn::Gt(cosBeta2, set(kNearGimbalLock)));
        for (int k = 0; k < 6; ++k)
            good = hn::And(good, hn::Le(hn::Abs(pose[k]), set(k < 3 ? machine.offsetBox : machine.angleBox)));
        return good;
    }
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace hexapose
HWY_AFTER_NAMESPACE();
#endif
