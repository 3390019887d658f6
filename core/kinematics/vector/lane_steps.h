// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Included once for each kind of vector unit.
#if defined(HEXAPOSE_LANE_STEPS) == defined(HWY_TARGET_TOGGLE)
#ifdef HEXAPOSE_LANE_STEPS
#undef HEXAPOSE_LANE_STEPS
#else
#define HEXAPOSE_LANE_STEPS
#endif

#include "core/kinematics/vector/lane_angles.h"
#include "core/kinematics/vector/newton_lanes.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <utility>

HWY_BEFORE_NAMESPACE();
namespace hexapose {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// The same machine. A compiler that knows its numbers from before keeps them in more registers than there
/// are, and reads them back from the stack; one that does not takes them from where they are.
HWY_INLINE const LaneMachine& unknown(const LaneMachine& machine) {
    const LaneMachine* same = &machine;
#if HWY_COMPILER_GCC || HWY_COMPILER_CLANG
    asm volatile("" : "+r"(same));
#endif
    return *same;
}

/// One leg, or several side by side: leg vector, and right-hand side |d| (l - |d|) of its equation.
template <class V>
struct LegRow {
    V d[3], e;
};

/// Moment of a leg about the centre of the base, a x d: its joint is at a + d.
template <class V>
HWY_INLINE void momentOf(const V* base, const V* d, V* m) {
    for (int k = 0; k < 3; ++k) {
        const int p = (k + 1) % 3, q = (k + 2) % 3;
        m[k] = hn::NegMulAdd(base[q], d[p], hn::Mul(base[p], d[q]));
    }
}

/// Adds u t to sum, four times the square of |d| - l where that is small; it has no other root than |d| = l.
template <class D, class V = hn::Vec<D>>
HWY_INLINE LegRow<V> evaluateLeg(D tag, const V* base, const V* joint, const V* centroid, const V (*R)[3],
                                 V length2, V inverse2, V& sum) {
    const auto set = [tag](double value) HWY_ATTR { return hn::Set(tag, value); };
    LegRow<V> leg;
    for (int k = 0; k < 3; ++k)
        leg.d[k] = hn::MulAdd(
            R[k][0], joint[0],
            hn::MulAdd(R[k][1], joint[1], hn::MulAdd(R[k][2], joint[2], hn::Sub(centroid[k], base[k]))));
    // |d| (l - |d|) without a root: with t = l^2 - d^2 and u = t / l^2 it is t/2 (1 - u/4 - u^2/8 - ...).
    // That vanishes at u = -4 too, so it is not what tells the end.
    const V t = hn::NegMulAdd(leg.d[0], leg.d[0],
                              hn::NegMulAdd(leg.d[1], leg.d[1], hn::NegMulAdd(leg.d[2], leg.d[2], length2)));
    const V part = hn::Mul(t, inverse2);
    leg.e = hn::Mul(t, hn::NegMulAdd(part, hn::MulAdd(part, set(0.0625), set(0.125)), set(0.5)));
    sum = hn::MulAdd(t, part, sum);
    return leg;
}

/// A Newton step and what it needs, of one pose in each lane.
template <class D>
struct LaneSteps {
    using Tag = D;
    using V = hn::Vec<D>;
    using M = hn::Mask<D>;
    static constexpr bool kOnePose = hn::MaxLanes(D()) == 1;

    struct Lengths {
        V l[kLegCount]; ///< in the order of elimination
    };
    struct Place {
        V c[3], q[4]; ///< centroid, from that of the base; quaternion w x y z of any length
    };
    struct Rotation {
        V r[3][3];
    };
    /// Rows of the linear system: leg vectors d, moments m = a x d, right-hand sides |d| (l - |d|).
    struct Rows {
        V d[3][kLegCount], m[3][kLegCount], e[kLegCount];
        V residual2;
    };
    struct Step {
        V t[3], w[3]; ///< displacement of the centroid, rotation vector
        V turn[4];    ///< its Cayley transform, a quaternion of any length
        V determinant;
    };
    struct Target {
        V l2[kLegCount], inverse2[kLegCount]; ///< squared lengths and their reciprocals
        V product;                            ///< of the lengths
    };
    struct Found {
        V pose[6]; ///< m and rad
        V cosBeta2;
    };

    static HWY_INLINE V set(double value) { return hn::Set(D(), value); }
    static HWY_INLINE V dot3(V a0, V b0, V a1, V b1, V a2, V b2) {
        return hn::MulAdd(a0, b0, hn::MulAdd(a1, b1, hn::Mul(a2, b2)));
    }
    /// One component of a cross product.
    static HWY_INLINE V minor(V a, V b, V c, V d) { return hn::NegMulAdd(c, d, hn::Mul(a, b)); }

    /// The same in all lanes.
    static HWY_INLINE Lengths lengthsOf(const LaneMachine& machine, const LegLengths& lengths) {
        Lengths out;
        for (std::size_t i = 0; i < kLegCount; ++i)
            out.l[i] = set(lengths[machine.order[i]] * (1.0 / machine.size));
        return out;
    }
    static HWY_INLINE M arePositive(const Lengths& lengths) {
        M positive = hn::Gt(lengths.l[0], hn::Zero(D()));
        for (int i = 1; i < kLegCount; ++i)
            positive = hn::And(positive, hn::Gt(lengths.l[i], hn::Zero(D())));
        return positive;
    }

    static HWY_INLINE Target target(const Lengths& lengths) {
        const V* l = lengths.l;
        Target out;
        // One division for six reciprocals.
        V left[kLegCount], right[kLegCount];
        left[0] = l[0];
        right[kLegCount - 1] = l[kLegCount - 1];
        for (int i = 1; i < kLegCount; ++i) {
            left[i] = hn::Mul(left[i - 1], l[i]);
            right[kLegCount - 1 - i] = hn::Mul(right[kLegCount - i], l[kLegCount - 1 - i]);
        }
        out.product = left[kLegCount - 1];
        const V inverseProduct = hn::Div(set(1.0), out.product);
        for (int i = 0; i < kLegCount; ++i) {
            V inverse = inverseProduct;
            if (i > 0)
                inverse = hn::Mul(inverse, left[i - 1]);
            if (i + 1 < kLegCount)
                inverse = hn::Mul(inverse, right[i + 1]);
            out.inverse2[i] = hn::Mul(inverse, inverse);
            out.l2[i] = hn::Mul(l[i], l[i]);
        }
        return out;
    }

    static HWY_INLINE Rotation rotation(const V* q) {
        const V w = q[0], x = q[1], y = q[2], z = q[3], one = set(1.0);
        const V k =
            hn::Div(set(2.0), hn::Add(hn::MulAdd(w, w, hn::Mul(x, x)), hn::MulAdd(y, y, hn::Mul(z, z))));
        const V kx = hn::Mul(k, x), ky = hn::Mul(k, y), kz = hn::Mul(k, z);
        Rotation out;
        out.r[0][0] = hn::NegMulAdd(kz, z, hn::NegMulAdd(ky, y, one));
        out.r[1][1] = hn::NegMulAdd(kz, z, hn::NegMulAdd(kx, x, one));
        out.r[2][2] = hn::NegMulAdd(ky, y, hn::NegMulAdd(kx, x, one));
        const V wx = hn::Mul(kx, w), wy = hn::Mul(ky, w), wz = hn::Mul(kz, w);
        const V xy = hn::Mul(kx, y), xz = hn::Mul(kx, z), yz = hn::Mul(ky, z);
        out.r[0][1] = hn::Sub(xy, wz);
        out.r[1][0] = hn::Add(xy, wz);
        out.r[0][2] = hn::Add(xz, wy);
        out.r[2][0] = hn::Sub(xz, wy);
        out.r[1][2] = hn::Sub(yz, wx);
        out.r[2][1] = hn::Add(yz, wx);
        return out;
    }

    static HWY_INLINE void evaluate(const LaneMachine& machine, const Place& at, const Rotation& R,
                                    const Target& to, Rows& rows) {
        rows.residual2 = hn::Zero(D());
        evaluateLegs(machine, at, R, to, rows, std::make_index_sequence<kLegCount>());
        rows.residual2 = hn::Mul(rows.residual2, set(0.25));
    }

    // Written out leg by leg: in a loop compilers keep each row twice.
    template <std::size_t... i>
    static HWY_INLINE void evaluateLegs(const LaneMachine& machine, const Place& at, const Rotation& R,
                                        const Target& to, Rows& rows, std::index_sequence<i...>) {
        (evaluateLegAt<i>(machine, at, R, to, rows), ...);
    }
    template <std::size_t i>
    static HWY_INLINE void evaluateLegAt(const LaneMachine& machine, const Place& at, const Rotation& R,
                                         const Target& to, Rows& rows) {
        V base[3], joint[3];
        for (std::size_t k = 0; k < 3; ++k) {
            base[k] = set(machine.base[k][placeInMemory(i)]);
            joint[k] = set(machine.joint[k][placeInMemory(i)]);
        }
        const auto leg = evaluateLeg(D(), base, joint, at.c, R.r, to.l2[i], to.inverse2[i], rows.residual2);
        for (std::size_t k = 0; k < 3; ++k)
            rows.d[k][i] = leg.d[k];
        rows.e[i] = leg.e;
    }

    /// Only for those who take a step.
    static HWY_INLINE void moments(const LaneMachine& machine, Rows& rows) {
        momentsOfLegs(unknown(machine), rows, std::make_index_sequence<kLegCount>());
    }
    template <std::size_t... i>
    static HWY_INLINE void momentsOfLegs(const LaneMachine& machine, Rows& rows, std::index_sequence<i...>) {
        (momentOfLeg<i>(machine, rows), ...);
    }
    template <std::size_t i>
    static HWY_INLINE void momentOfLeg(const LaneMachine& machine, Rows& rows) {
        V base[3], m[3];
        const V d[] = {rows.d[0][i], rows.d[1][i], rows.d[2][i]};
        for (std::size_t k = 0; k < 3; ++k)
            base[k] = set(machine.base[k][placeInMemory(i)]);
        momentOf(base, d, m);
        for (std::size_t k = 0; k < 3; ++k)
            rows.m[k][i] = m[k];
    }

    /// Inverse of three rows times its determinant: columns are cross products of the other two.
    static HWY_INLINE V adjugate(const V rows[3][3], V out[3][3]) {
        for (int k = 0; k < 3; ++k) {
            const V* a = rows[(k + 1) % 3];
            const V* b = rows[(k + 2) % 3];
            out[0][k] = minor(a[1], b[2], a[2], b[1]);
            out[1][k] = minor(a[2], b[0], a[0], b[2]);
            out[2][k] = minor(a[0], b[1], a[1], b[0]);
        }
        return dot3(rows[0][0], out[0][0], rows[0][1], out[1][0], rows[0][2], out[2][0]);
    }

    /// The step by 3x3 blocks: the first triple gives the displacement in terms of the rotation, which leaves
    /// three equations of the second for the rotation. These are kept times the first determinant, so that
    /// its reciprocal is not waited for.
    static HWY_INLINE Step solve(const Rows& rows, const Place& at) {
        V legs[3][3], adjugate1[3][3];
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                legs[i][k] = rows.d[k][i];
        const V det1 = adjugate(legs, adjugate1);
        V mixed[3][3], x[3], rest[3][3], right[3], adjugate2[3][3];
        for (int k = 0; k < 3; ++k)
            x[k] = dot3(adjugate1[k][0], rows.e[0], adjugate1[k][1], rows.e[1], adjugate1[k][2], rows.e[2]);
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                mixed[k][j] = dot3(adjugate1[k][0], rows.m[j][0], adjugate1[k][1], rows.m[j][1],
                                   adjugate1[k][2], rows.m[j][2]);
        for (int i = 0; i < 3; ++i) {
            const auto less = [&rows, i](V value, V x0, V x1, V x2) HWY_ATTR {
                return hn::NegMulAdd(
                    rows.d[0][3 + i], x0,
                    hn::NegMulAdd(rows.d[1][3 + i], x1, hn::NegMulAdd(rows.d[2][3 + i], x2, value)));
            };
            right[i] = less(hn::Mul(det1, rows.e[3 + i]), x[0], x[1], x[2]);
            for (int j = 0; j < 3; ++j)
                rest[i][j] = less(hn::Mul(det1, rows.m[j][3 + i]), mixed[0][j], mixed[1][j], mixed[2][j]);
        }
        const V det2 = adjugate(rest, adjugate2);
        V w[3];
        for (int k = 0; k < 3; ++k)
            w[k] = dot3(adjugate2[k][0], right[0], adjugate2[k][1], right[1], adjugate2[k][2], right[2]);
        for (int k = 0; k < 3; ++k)
            x[k] = hn::NegMulAdd(
                mixed[k][0], w[0],
                hn::NegMulAdd(mixed[k][1], w[1], hn::NegMulAdd(mixed[k][2], w[2], hn::Mul(det2, x[k]))));
        return stepOf(det1, det2, w, x, at);
    }

    /// From the solution of both blocks: rotation w times det2, displacement x times det1 det2.
    static HWY_INLINE Step stepOf(V det1, V det2, const V* w, const V* x, const Place& at) {
        // The rotation does not wait for the reciprocal.
        const V inverse = hn::Div(set(1.0), hn::Mul(det1, det2)), scale = hn::Mul(inverse, det1);
        Step step;
        step.turn[0] = hn::Add(det2, det2);
        for (int k = 0; k < 3; ++k) {
            step.turn[1 + k] = w[k];
            step.w[k] = hn::Mul(scale, w[k]);
        }
        for (int k = 0; k < 3; ++k) { // from the centre of the base to that of the platform
            const int p = (k + 1) % 3, q = (k + 2) % 3;
            step.t[k] = hn::MulAdd(inverse, x[k], minor(step.w[p], at.c[q], step.w[q], at.c[p]));
        }
        const V inverse1 = hn::Mul(inverse, det2);
        step.determinant = hn::Mul(det2, hn::Mul(inverse1, inverse1)); // det2 was taken of rows times det1
        return step;
    }

    /// The rotation by the Cayley transform of the step: no trigonometry, exact to third order.
    static HWY_INLINE void move(Place& place, const Step& step) {
        for (int k = 0; k < 3; ++k)
            place.c[k] = hn::Add(place.c[k], step.t[k]);
        const V w = place.q[0], x = place.q[1], y = place.q[2], z = place.q[3];
        const V h = step.turn[0], hx = step.turn[1], hy = step.turn[2], hz = step.turn[3];
        place.q[0] = hn::NegMulAdd(hx, x, hn::NegMulAdd(hy, y, minor(h, w, hz, z)));
        place.q[1] = hn::MulAdd(hx, w, hn::MulAdd(hy, z, minor(h, x, hz, y)));
        place.q[2] = hn::MulAdd(hy, w, hn::MulAdd(hz, x, minor(h, y, hx, z)));
        place.q[3] = hn::MulAdd(hz, w, hn::MulAdd(hx, y, minor(h, z, hy, x)));
    }

    /// What the legs miss at home.
    static HWY_INLINE Lengths errorAtHome(const LaneMachine& machine, const Lengths& lengths) {
        Lengths error;
        for (std::size_t i = 0; i < kLegCount; ++i)
            error.l[i] = hn::Sub(lengths.l[i], set(machine.homeLength[placeInMemory(i)]));
        return error;
    }
    static HWY_INLINE V squared(const Lengths& error) {
        V sum = hn::Mul(error.l[0], error.l[0]);
        for (int i = 1; i < kLegCount; ++i)
            sum = hn::MulAdd(error.l[i], error.l[i], sum);
        return sum;
    }
    static HWY_INLINE Step stepFromHome(const LaneMachine& machine, const Lengths& error) {
        V x[kLegCount];
        for (std::size_t i = 0; i < kLegCount; ++i) {
            const std::size_t at = placeInMemory(i);
            x[i] = hn::Mul(set(machine.homeInverse[0][at]), error.l[0]);
            for (std::size_t j = 1; j < kLegCount; ++j)
                x[i] = hn::MulAdd(set(machine.homeInverse[j][at]), error.l[j], x[i]);
        }
        return {{x[0], x[1], x[2]},
                {x[3], x[4], x[5]},
                {set(2.0), x[3], x[4], x[5]},
                set(machine.homeDeterminant)};
    }

    static HWY_INLINE V stepSquare(const LaneMachine& machine, const Step& step) {
        const V turn = dot3(step.w[0], step.w[0], step.w[1], step.w[1], step.w[2], step.w[2]);
        return hn::MulAdd(set(machine.spread * machine.spread), turn,
                          dot3(step.t[0], step.t[0], step.t[1], step.t[1], step.t[2], step.t[2]));
    }

    /// Of angles, the same in all lanes.
    static HWY_INLINE void sinCosOfHalves(const EulerAngles& angles, V* s, V* c) {
        const V half[] = {set(0.5 * angles.alpha), set(0.5 * angles.beta), set(0.5 * angles.gamma)};
        for (int k = 0; k < 3; ++k) {
            s[k] = hn::Sin(D(), half[k]);
            c[k] = hn::Cos(D(), half[k]);
        }
    }

    static HWY_INLINE V offsetOf(const LaneMachine& machine, const Place& at, const Rotation& R,
                                 std::size_t k) {
        const V arm = dot3(R.r[k][0], set(machine.centroidInP[0]), R.r[k][1], set(machine.centroidInP[1]),
                           R.r[k][2], set(machine.centroidInP[2]));
        return hn::Mul(hn::Sub(hn::Sub(at.c[k], arm), set(machine.homeOrigin[k])), set(machine.size));
    }
    static HWY_INLINE V cosBeta2(const Rotation& R) {
        return hn::MulAdd(R.r[0][0], R.r[0][0], hn::Mul(R.r[1][0], R.r[1][0]));
    }
    static HWY_INLINE Found found(const LaneMachine& machine, const Place& at, const Rotation& R) {
        Found out;
        for (std::size_t k = 0; k < 3; ++k)
            out.pose[k] = offsetOf(machine, at, R, k);
        out.cosBeta2 = cosBeta2(R);
        out.pose[3] = arcTangent(D(), R.r[2][1], R.r[2][2]);
        out.pose[4] = arcTangent(D(), hn::Neg(R.r[2][0]), hn::Sqrt(out.cosBeta2));
        out.pose[5] = arcTangent(D(), R.r[1][0], R.r[0][0]);
        return out;
    }
    static HWY_INLINE M isInBox(const LaneMachine& machine, const Found& found) {
        M inside = hn::Le(hn::Abs(found.pose[0]), set(machine.offsetBox));
        for (int k = 1; k < 6; ++k)
            inside = hn::And(
                inside, hn::Le(hn::Abs(found.pose[k]), set(k < 3 ? machine.offsetBox : machine.angleBox)));
        return inside;
    }
    /// Of the first lane.
    static HWY_INLINE void store(const Found& found, Pose& pose) {
        for (int k = 0; k < 3; ++k)
            pose.offset[k] = hn::GetLane(found.pose[k]);
        pose.angles = {hn::GetLane(found.pose[3]), hn::GetLane(found.pose[4]), hn::GetLane(found.pose[5])};
    }
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace hexapose
HWY_AFTER_NAMESPACE();
#endif
