// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Compiled once for each kind of vector unit; the one for this processor is chosen when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kinematics/newton_lanes.cpp"
#include "core/kinematics/newton_lanes.h"
#include "core/kinematics/lane_targets.h"

#include <hwy/foreach_target.h>
// The targets first.
#include "core/kinematics/lane_angles.h"
#include "core/kinematics/lane_steps.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
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

using Many = hn::CappedTag<double, LaneBlock::kMostLanes>;

template <class D>
struct Newton : LaneSteps<D> {
    using Steps = LaneSteps<D>;
    using Steps::dot3, Steps::evaluate, Steps::move, Steps::rotation, Steps::set, Steps::solve,
        Steps::stepFromHome, Steps::stepSquare, Steps::target;
    using typename Steps::M;
    using typename Steps::Place;
    using typename Steps::Rotation;
    using typename Steps::Rows;
    using typename Steps::Step;
    using typename Steps::Target;
    using typename Steps::V;
    static constexpr bool kSingle = hn::MaxLanes(D()) == 1;

    struct Run {
        Place place;
        Rotation rotation; ///< of the place
        V residual2, startResidual2, determinant, inverseProduct;
        V step2; ///< square of the norm of the step from where the determinant was taken
        V iterations;
        M solved;
    };

    /// evaluate() of a single pose: a leg of each triple side by side.
    static HWY_INLINE void evaluateInPairs(const LaneMachine& machine, const Run& run, const Target& to,
                                           Rows& rows) {
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
            for (std::size_t k = 0; k < 3; ++k) {
                rows.d[k][i] = firstOf(legs.d[k]);
                rows.d[k][3 + i] = secondOf(legs.d[k]);
                rows.m[k][i] = firstOf(legs.m[k]);
                rows.m[k][3 + i] = secondOf(legs.m[k]);
            }
            rows.e[i] = firstOf(legs.e);
            rows.e[3 + i] = secondOf(legs.e);
        }
        rows.residual2 = hn::Add(firstOf(sum), secondOf(sum));
    }

    /// Takes a step in the lanes that are still at work.
    static HWY_INLINE void take(const LaneMachine& machine, Step& step, M active, Run& run) {
        if constexpr (kSingle) {
            run.determinant = step.determinant;
            run.step2 = stepSquare(machine, step);
            run.iterations = hn::Add(run.iterations, set(1.0));
        } else {
            for (int k = 0; k < 3; ++k) {
                step.t[k] = hn::IfThenElseZero(active, step.t[k]);
                step.w[k] = hn::IfThenElseZero(active, step.w[k]);
            }
            run.determinant = hn::IfThenElse(active, step.determinant, run.determinant);
            run.step2 = hn::IfThenElse(active, stepSquare(machine, step), run.step2);
            run.iterations = hn::Add(run.iterations, hn::IfThenElseZero(active, set(1.0)));
        }
        move(run.place, step);
        run.rotation = rotation(run.place.q);
    }

    /// Place and rotation are set. fromHome: it is home, whose Jacobian was inverted beforehand.
    static HWY_INLINE void iterate(const LaneMachine& machine, const V* l, bool fromHome, double tolerance,
                                   int maxIterations, Run& run) {
        const V tolerance2 = set(tolerance * tolerance), zero = hn::Zero(D());
        const Target to = target(l);
        run.inverseProduct = to.inverseProduct;
        run.determinant = run.step2 = run.iterations = zero;
        run.residual2 = set(std::numeric_limits<double>::max());
        M active = hn::Gt(l[0], zero);
        for (int i = 1; i < kLegCount; ++i)
            active = hn::And(active, hn::Gt(l[i], zero));
        run.solved = hn::Lt(zero, zero);
        int steps = 0;
        if (fromHome) {
            V error[kLegCount];
            run.residual2 = zero;
            for (std::size_t i = 0; i < kLegCount; ++i) {
                error[i] = hn::Sub(l[i], set(machine.homeLength[i]));
                run.residual2 = hn::MulAdd(error[i], error[i], run.residual2);
            }
            run.startResidual2 = run.residual2;
            run.solved = hn::And(active, hn::Le(run.residual2, tolerance2));
            active = hn::AndNot(run.solved, active);
            if (hn::AllFalse(D(), active))
                return;
            Step step = stepFromHome(machine, error);
            take(machine, step, active, run);
            steps = 1;
        }
        for (;; ++steps) {
            Rows rows;
            if constexpr (kSingle && kHasPairs)
                evaluateInPairs(machine, run, to, rows);
            else
                evaluate(machine, run.place, run.rotation, to, rows);
            if (steps == 0)
                run.startResidual2 = rows.residual2;
            // Not a number is not less.
            active = hn::And(active, hn::Lt(rows.residual2, hn::Mul(run.residual2, set(kLeastDecrease))));
            run.residual2 = hn::IfThenElse(active, rows.residual2, run.residual2);
            const M done = hn::And(active, hn::Le(rows.residual2, tolerance2));
            run.solved = hn::Or(run.solved, done);
            active = hn::AndNot(done, active);
            if (steps >= maxIterations || steps >= kMostSteps || hn::AllFalse(D(), active))
                return;
            Step step = solve(rows);
            take(machine, step, active, run);
        }
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
            hn::Mul(hn::Mul(run.determinant, run.inverseProduct), set(machine.determinantScale));
        const V least = hn::MulAdd(set(kSlopeMargin * machine.determinantSlope), hn::Sqrt(run.step2),
                                   set(machine.leastDeterminant));
        M good = hn::And(run.solved, hn::Gt(determinant, least));
        good = hn::And(good, hn::Gt(cosBeta2, set(kNearGimbalLock)));
        for (int k = 0; k < 6; ++k)
            good = hn::And(good, hn::Le(hn::Abs(pose[k]), set(k < 3 ? machine.offsetBox : machine.angleBox)));
        return good;
    }
};

/// Place and rotation of a pose.
HWY_INLINE void begin(const LaneMachine& machine, const PoseVector& pose, Newton<One>::Run& run) {
    using N = Newton<One>;
    const auto half = [&pose](int k) HWY_ATTR { return N::set(0.5 * pose[3 + k]); };
    N::V s[3], c[3];
    const bool isShort =
        std::max({std::abs(pose[3]), std::abs(pose[4]), std::abs(pose[5])}) <= 2.0 * kShortAngle;
    if (HWY_LIKELY(isShort && kHasPairs)) {
        hn::Vec<Two> sines, cosines;
        shortSinCos(Two(), pairOf(half(0), half(1)), sines, cosines);
        s[0] = firstOf(sines);
        s[1] = secondOf(sines);
        c[0] = firstOf(cosines);
        c[1] = secondOf(cosines);
        shortSinCos(One(), half(2), s[2], c[2]);
    } else {
        for (int k = 0; k < 3; ++k) {
            s[k] = hn::Sin(One(), half(k));
            c[k] = hn::Cos(One(), half(k));
        }
    }
    const auto cc = hn::Mul(c[2], c[1]), ss = hn::Mul(s[2], s[1]), cs = hn::Mul(c[2], s[1]),
               sc = hn::Mul(s[2], c[1]);
    run.place.q[0] = hn::MulAdd(cc, c[0], hn::Mul(ss, s[0]));
    run.place.q[1] = N::Steps::minor(cc, s[0], ss, c[0]);
    run.place.q[2] = hn::MulAdd(cs, c[0], hn::Mul(sc, s[0]));
    run.place.q[3] = N::Steps::minor(sc, c[0], cs, s[0]);
    run.rotation = N::rotation(run.place.q);
    for (std::size_t k = 0; k < 3; ++k)
        run.place.c[k] = hn::Add(
            N::set(machine.homeOrigin[k] + pose[static_cast<Eigen::Index>(k)] / machine.size),
            N::dot3(run.rotation.r[k][0], N::set(machine.centroidInP[0]), run.rotation.r[k][1],
                    N::set(machine.centroidInP[1]), run.rotation.r[k][2], N::set(machine.centroidInP[2])));
}

template <class D>
HWY_INLINE void beginAtHome(const LaneMachine& machine, typename Newton<D>::Run& run) {
    for (std::size_t k = 0; k < 3; ++k)
        run.place.c[k] = hn::Set(D(), machine.homeOrigin[k] + machine.centroidInP[k]);
    for (int k = 0; k < 4; ++k)
        run.place.q[k] = hn::Set(D(), k == 0 ? 1.0 : 0.0);
    run.rotation = Newton<D>::rotation(run.place.q);
}

void solveOne(const LaneMachine& machine, const LegLengths& lengths, const PoseVector& start,
              double tolerance, int maxIterations, LaneSolution& solution) {
    using N = Newton<One>;
    const bool fromHome = (start.array() == 0.0).all();
    N::V l[kLegCount];
    const double toSizes = 1.0 / machine.size;
    for (std::size_t i = 0; i < kLegCount; ++i)
        l[i] = N::set(lengths[machine.order[i]] * toSizes);
    N::Run run;
    if (fromHome)
        beginAtHome<One>(machine, run);
    else
        begin(machine, start, run);
    N::iterate(machine, l, fromHome, tolerance * toSizes, maxIterations, run);

    N::V pose[6], cosBeta2;
    N::toPose(machine, run, pose, cosBeta2);
    solution.solved = hn::AllTrue(One(), run.solved);
    solution.clear = hn::AllTrue(One(), N::clear(machine, run, cosBeta2, pose));
    for (int k = 0; k < 6; ++k)
        solution.pose[k] = hn::GetLane(pose[k]);
    for (std::size_t k = 0; k < 3; ++k)
        solution.centroid[k] = hn::GetLane(run.place.c[k]);
    for (std::size_t k = 0; k < 4; ++k)
        solution.rotation[k] = hn::GetLane(run.place.q[k]);
    solution.residual = hn::GetLane(hn::Sqrt(run.residual2)) * machine.size;
    solution.startResidual = hn::GetLane(hn::Sqrt(run.startResidual2)) * machine.size;
    solution.iterations = static_cast<int>(hn::GetLane(run.iterations));
}

std::size_t countLanes() {
    return hn::Lanes(Many());
}

void solveMany(const LaneMachine& machine, const LegLengths* lengths, std::size_t count, double tolerance,
               int maxIterations, LaneBlock& block) {
    using N = Newton<Many>;
    using Index = hn::RebindToSigned<Many>;
    // Lanes without a row of their own repeat the last one.
    const auto row = hn::Min(hn::Iota(Index(), 0), hn::Set(Index(), static_cast<std::int64_t>(count) - 1));
    const double* first = lengths->data();
    const double toSizes = 1.0 / machine.size;
    const auto offset = hn::Add(hn::ShiftLeft<2>(row), hn::ShiftLeft<1>(row)); // 6 numbers a row
    N::V l[kLegCount];
    for (std::size_t i = 0; i < kLegCount; ++i)
        l[i] = hn::Mul(hn::GatherIndex(Many(), first + machine.order[i], offset), N::set(toSizes));
    N::Run run;
    beginAtHome<Many>(machine, run);
    N::iterate(machine, l, true, tolerance * toSizes, maxIterations, run);

    N::V pose[6], cosBeta2;
    N::toPose(machine, run, pose, cosBeta2);
    for (std::size_t k = 0; k < 6; ++k)
        hn::Store(pose[k], Many(), block.pose[k].data());
    hn::Store(hn::Mul(hn::Sqrt(run.residual2), N::set(machine.size)), Many(), block.residual.data());
    hn::Store(run.iterations, Many(), block.iterations.data());
    alignas(64) LaneBlock::Lanes flags;
    hn::Store(hn::IfThenElseZero(N::clear(machine, run, cosBeta2, pose), N::set(1.0)), Many(), flags.data());
    for (std::size_t i = 0; i < hn::Lanes(Many()); ++i)
        block.clear[i] = flags[i] != 0.0;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace hexapose
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hexapose {

HWY_EXPORT(solveOne);
HWY_EXPORT(countLanes);
HWY_EXPORT(solveMany);

void solveLane(const LaneMachine& machine, const LegLengths& lengths, const PoseVector& start,
               double tolerance, int maxIterations, LaneSolution& solution) noexcept {
    HWY_DYNAMIC_DISPATCH(solveOne)(machine, lengths, start, tolerance, maxIterations, solution);
}

std::size_t laneCount() noexcept {
    return HWY_DYNAMIC_DISPATCH(countLanes)();
}

void solveLanes(const LaneMachine& machine, const LegLengths* lengths, std::size_t count, double tolerance,
                int maxIterations, LaneBlock& block) noexcept {
    HWY_DYNAMIC_DISPATCH(solveMany)(machine, lengths, count, tolerance, maxIterations, block);
}

} // namespace hexapose
#endif
