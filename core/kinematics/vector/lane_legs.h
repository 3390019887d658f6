// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Included once for each kind of vector unit.
#if defined(HEXAPOSE_LANE_LEGS) == defined(HWY_TARGET_TOGGLE)
#ifdef HEXAPOSE_LANE_LEGS
#undef HEXAPOSE_LANE_LEGS
#else
#define HEXAPOSE_LANE_LEGS
#endif

#include "core/kinematics/vector/lane_angles.h"
#include "core/kinematics/vector/lane_steps.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace hexapose {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR // which has no lanes to change places in

/// A Newton step of a single pose: the three legs of a triple stand in lanes side by side, the last of them
/// twice, for lanes come in fours. What is not of a leg is the same in all lanes.
template <class D>
struct LaneLegs : LaneSteps<D> {
    using Steps = LaneSteps<D>;
    using Steps::cosBeta2, Steps::dot3, Steps::minor, Steps::offsetOf, Steps::set, Steps::stepOf;
    using typename Steps::M;
    using typename Steps::Place;
    using typename Steps::Rotation;
    using typename Steps::Step;
    using typename Steps::V;
    static constexpr bool kOnePose = true;

    struct Lengths {
        V first, second;
    };
    struct Target {
        V l2[2], inverse2[2]; ///< squared lengths and their reciprocals
        V product;            ///< of the lengths
    };
    struct Triple {
        V d[3], m[3], e; ///< leg vectors, moments a x d, right-hand sides |d| (l - |d|)
    };
    struct Rows {
        Triple first, second;
        V residual2;
    };
    struct Found {
        V offset, angles; ///< m and rad, in the lanes
        V cosBeta2;
    };

    /// Lane i gets what was in lane i + By of three.
    template <int By>
    static HWY_INLINE V turned(V v) {
        alignas(32) static constexpr std::int64_t kFrom[2][4] = {{1, 2, 0, 0}, {2, 0, 1, 1}};
        return hn::TableLookupLanes(v, hn::SetTableIndices(D(), kFrom[By - 1]));
    }
    static HWY_INLINE V laneInAll(V v, int lane) {
        alignas(32) static constexpr std::int64_t kFrom[3][4] = {{}, {1, 1, 1, 1}, {2, 2, 2, 2}};
        return hn::TableLookupLanes(v, hn::SetTableIndices(D(), kFrom[lane]));
    }
    /// a, b, c and c once more, each the same in all lanes.
    static HWY_INLINE V sideBySide(V a, V b, V c) { return hn::ConcatUpperLower(D(), c, hn::OddEven(b, a)); }
    static HWY_INLINE V withoutRepeated(V v) { return hn::IfThenElseZero(hn::FirstN(D(), 3), v); }
    /// In all lanes, with nothing in the fourth.
    static HWY_INLINE V sum(V v) {
        const V pairs = hn::Add(v, hn::Shuffle01(v));
        return hn::Add(pairs, hn::SwapAdjacentBlocks(pairs));
    }

    static HWY_INLINE Lengths lengthsOf(const LaneMachine& machine, const LegLengths& lengths) {
        const auto leg = [&](std::size_t i) HWY_ATTR { return set(lengths[machine.order[i]]); };
        const V toSizes = set(1.0 / machine.size);
        return {hn::Mul(sideBySide(leg(0), leg(1), leg(2)), toSizes),
                hn::Mul(sideBySide(leg(3), leg(4), leg(5)), toSizes)};
    }
    static HWY_INLINE M arePositive(const Lengths& lengths) {
        const V zero = hn::Zero(D());
        const bool all = hn::AllTrue(D(), hn::And(hn::Gt(lengths.first, zero), hn::Gt(lengths.second, zero)));
        return hn::Eq(set(all ? 0.0 : 1.0), zero);
    }
    static HWY_INLINE Target target(const Lengths& lengths) {
        Target out;
        out.l2[0] = hn::Mul(lengths.first, lengths.first);
        out.l2[1] = hn::Mul(lengths.second, lengths.second);
        for (int i = 0; i < 2; ++i)
            out.inverse2[i] = hn::Div(set(1.0), out.l2[i]);
        const V pairs = hn::Mul(lengths.first, lengths.second);
        out.product = laneInAll(hn::Mul(pairs, hn::Mul(turned<1>(pairs), turned<2>(pairs))), 0);
        return out;
    }

    static HWY_INLINE void evaluate(const LaneMachine& machine, const Place& at, const Rotation& R,
                                    const Target& to, Rows& rows) {
        V sum2 = hn::Zero(D());
        evaluateTriple<0>(machine, at, R, to, rows.first, sum2);
        evaluateTriple<1>(machine, at, R, to, rows.second, sum2);
        rows.residual2 = hn::Mul(sum(withoutRepeated(sum2)), set(0.25));
    }
    template <std::size_t which>
    static HWY_INLINE void evaluateTriple(const LaneMachine& machine, const Place& at, const Rotation& R,
                                          const Target& to, Triple& triple, V& sum2) {
        V base[3], joint[3];
        for (std::size_t k = 0; k < 3; ++k) {
            base[k] = hn::LoadU(D(), machine.base[k].data() + 4 * which);
            joint[k] = hn::LoadU(D(), machine.joint[k].data() + 4 * which);
        }
        const auto legs = evaluateLeg(D(), base, joint, at.c, R.r, to.l2[which], to.inverse2[which], sum2);
        for (int k = 0; k < 3; ++k)
            triple.d[k] = legs.d[k];
        triple.e = legs.e;
    }
    static HWY_INLINE void moments(const LaneMachine& machine, Rows& rows) {
        V base[2][3];
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t which = 0; which < 2; ++which)
                base[which][k] = hn::LoadU(D(), machine.base[k].data() + 4 * which);
        momentOf(base[0], rows.first.d, rows.first.m);
        momentOf(base[1], rows.second.d, rows.second.m);
    }

    /// Cross products of the next two rows, each in a lane; returns the determinant, in all lanes.
    static HWY_INLINE V adjugate(const V* rows, V* out) {
        V a[3], b[3];
        for (int k = 0; k < 3; ++k) {
            a[k] = turned<1>(rows[k]);
            b[k] = turned<2>(rows[k]);
        }
        for (int k = 0; k < 3; ++k)
            out[k] = minor(a[(k + 1) % 3], b[(k + 2) % 3], a[(k + 2) % 3], b[(k + 1) % 3]);
        return laneInAll(dot3(rows[0], out[0], rows[1], out[1], rows[2], out[2]), 0);
    }

    /// As in LaneSteps. Both triples meet in the products of a leg of the second with the adjugate of the
    /// first: beside[n] has those of leg i with its column i + n.
    static HWY_INLINE Step solve(const Rows& rows, const Place& at) {
        const Triple& first = rows.first;
        const Triple& second = rows.second;
        V adjugate1[3], adjugate2[3], next[3], last[3];
        const V det1 = adjugate(first.d, adjugate1);
        for (int k = 0; k < 3; ++k) {
            next[k] = turned<1>(adjugate1[k]);
            last[k] = turned<2>(adjugate1[k]);
        }
        const auto with = [&second](const V* column) HWY_ATTR {
            return dot3(second.d[0], column[0], second.d[1], column[1], second.d[2], column[2]);
        };
        const V beside[] = {with(adjugate1), with(next), with(last)};
        const auto less = [&](V value, V taken) HWY_ATTR {
            return hn::NegMulAdd(beside[2], turned<2>(taken),
                                 hn::NegMulAdd(beside[1], turned<1>(taken),
                                               hn::NegMulAdd(beside[0], taken, hn::Mul(det1, value))));
        };
        V rest[3];
        for (int j = 0; j < 3; ++j)
            rest[j] = less(second.m[j], first.m[j]);
        const V right = withoutRepeated(less(second.e, first.e));
        const V det2 = adjugate(rest, adjugate2);
        V w[3], x[3];
        for (int k = 0; k < 3; ++k)
            w[k] = sum(hn::Mul(adjugate2[k], right));
        const V left = withoutRepeated(hn::NegMulAdd(
            first.m[0], w[0],
            hn::NegMulAdd(first.m[1], w[1], hn::NegMulAdd(first.m[2], w[2], hn::Mul(det2, first.e)))));
        for (int k = 0; k < 3; ++k)
            x[k] = sum(hn::Mul(adjugate1[k], left));
        return stepOf(det1, det2, w, x, at);
    }

    static HWY_INLINE Lengths errorAtHome(const LaneMachine& machine, const Lengths& lengths) {
        return {hn::Sub(lengths.first, hn::LoadU(D(), machine.homeLength.data())),
                hn::Sub(lengths.second, hn::LoadU(D(), machine.homeLength.data() + 4))};
    }
    static HWY_INLINE V squared(const Lengths& error) {
        return sum(
            withoutRepeated(hn::MulAdd(error.first, error.first, hn::Mul(error.second, error.second))));
    }
    static HWY_INLINE Step stepFromHome(const LaneMachine& machine, const Lengths& error) {
        V t = hn::Zero(D()), w = t;
        for (std::size_t i = 0; i < kLegCount; ++i) {
            const V one = laneInAll(i < 3 ? error.first : error.second, static_cast<int>(i % 3));
            t = hn::MulAdd(hn::LoadU(D(), machine.homeInverse[i].data()), one, t);
            w = hn::MulAdd(hn::LoadU(D(), machine.homeInverse[i].data() + 4), one, w);
        }
        Step step;
        step.turn[0] = set(2.0);
        for (int k = 0; k < 3; ++k) {
            step.t[k] = laneInAll(t, k);
            step.w[k] = step.turn[1 + k] = laneInAll(w, k);
        }
        step.determinant = set(machine.homeDeterminant);
        return step;
    }

    static HWY_INLINE void sinCosOfHalves(const EulerAngles& angles, V* s, V* c) {
        const double furthest =
            std::max({std::abs(angles.alpha), std::abs(angles.beta), std::abs(angles.gamma)});
        if (HWY_UNLIKELY(!(furthest <= 2.0 * kShortAngle)))
            return Steps::sinCosOfHalves(angles, s, c);
        const V half = hn::Mul(sideBySide(set(angles.alpha), set(angles.beta), set(angles.gamma)), set(0.5));
        V sines, cosines;
        shortSinCos(D(), half, sines, cosines);
        for (int k = 0; k < 3; ++k) {
            s[k] = laneInAll(sines, k);
            c[k] = laneInAll(cosines, k);
        }
    }

    static HWY_INLINE Found found(const LaneMachine& machine, const Place& at, const Rotation& R) {
        Found out;
        out.cosBeta2 = cosBeta2(R);
        out.offset =
            sideBySide(offsetOf(machine, at, R, 0), offsetOf(machine, at, R, 1), offsetOf(machine, at, R, 2));
        out.angles = arcTangent(D(), sideBySide(R.r[2][1], hn::Neg(R.r[2][0]), R.r[1][0]),
                                sideBySide(R.r[2][2], hn::Sqrt(out.cosBeta2), R.r[0][0]));
        return out;
    }
    static HWY_INLINE M isInBox(const LaneMachine& machine, const Found& found) {
        return hn::And(hn::Le(hn::Abs(found.offset), set(machine.offsetBox)),
                       hn::Le(hn::Abs(found.angles), set(machine.angleBox)));
    }
    static HWY_INLINE void store(const Found& found, Pose& pose) {
        alignas(32) double offset[4], angles[4];
        hn::Store(found.offset, D(), offset);
        hn::Store(found.angles, D(), angles);
        pose.offset = {offset[0], offset[1], offset[2]};
        pose.angles = {angles[0], angles[1], angles[2]};
    }
};

/// Legs side by side where vectors hold four numbers.
using Four = hn::CappedTag<double, 4>;
using OnePose =
    std::conditional_t<hn::MaxLanes(Four()) == 4, LaneLegs<Four>, LaneSteps<hn::CappedTag<double, 1>>>;

#else
using OnePose = LaneSteps<hn::CappedTag<double, 1>>;
#endif

} // namespace
} // namespace HWY_NAMESPACE
} // namespace hexapose
HWY_AFTER_NAMESPACE();
#endif
