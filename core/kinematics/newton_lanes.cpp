// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Compiled once for each kind of vector unit; the one for this processor is chosen when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kinematics/newton_lanes.cpp"
#include "core/kinematics/newton_lanes.h"
#include "core/kinematics/lane_targets.h"

#include <hwy/foreach_target.h>
// The targets first.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

using One = hn::CappedTag<double, 1>;
using Two = hn::CappedTag<double, 2>;
using Many = hn::CappedTag<double, LaneBlock::kMostLanes>;

// Two numbers in one vector, where vectors hold more than one.
constexpr bool kHasPairs = hn::MaxLanes(Two()) == 2;
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE hn::Vec<Two> pairOf(hn::Vec<One> a, hn::Vec<One>) {
    return a;
}
HWY_INLINE hn::Vec<One> secondOf(hn::Vec<Two> both) {
    return both;
}
#else
HWY_INLINE hn::Vec<Two> pairOf(hn::Vec<One> a, hn::Vec<One> b) {
    return hn::InterleaveLower(Two(), hn::Set(Two(), hn::GetLane(a)), hn::Set(Two(), hn::GetLane(b)));
}
HWY_INLINE hn::Vec<One> secondOf(hn::Vec<Two> both) {
    return hn::UpperHalf(One(), both);
}
#endif
HWY_INLINE hn::Vec<One> firstOf(hn::Vec<Two> both) {
    return hn::Set(One(), hn::GetLane(both));
}

template <class D>
struct Newton {
    using V = hn::Vec<D>;
    using M = hn::Mask<D>;
    static constexpr bool kSingle = hn::MaxLanes(D()) == 1;

    struct Place {
        V c[3], q[4]; ///< centroid; quaternion w x y z of any length
    };
    struct Rotation {
        V r[3][3];
    };
    /// Rows of the linear system: leg vectors d, moments m = R b x d, right-hand sides |d| (l - |d|).
    struct Rows {
        V d[3][kLegCount], m[3][kLegCount], e[kLegCount];
        V residual2;
    };
    struct Step {
        V t[3], w[3]; ///< displacement of the centroid, rotation vector
        V determinant;
    };
    struct Target {
        V l2[kLegCount], inverse2[kLegCount]; ///< squared lengths and their reciprocals
        V inverseProduct;
    };
    struct Run {
        Place place;
        Rotation rotation; ///< of the place
        V residual2, startResidual2, determinant, inverseProduct;
        V step2; ///< square of the norm of the step from where the determinant was taken
        V iterations;
        M solved;
    };

    static HWY_INLINE V set(double value) { return hn::Set(D(), value); }
    static HWY_INLINE V dot3(V a0, V b0, V a1, V b1, V a2, V b2) {
        return hn::MulAdd(a0, b0, hn::MulAdd(a1, b1, hn::Mul(a2, b2)));
    }
    /// One component of a cross product.
    static HWY_INLINE V minor(V a, V b, V c, V d) { return hn::NegMulAdd(c, d, hn::Mul(a, b)); }

    static HWY_INLINE Target target(const V* l) {
        Target out;
        // One division for six reciprocals.
        V left[kLegCount], right[kLegCount];
        left[0] = l[0];
        right[kLegCount - 1] = l[kLegCount - 1];
        for (int i = 1; i < kLegCount; ++i) {
            left[i] = hn::Mul(left[i - 1], l[i]);
            right[kLegCount - 1 - i] = hn::Mul(right[kLegCount - i], l[kLegCount - 1 - i]);
        }
        out.inverseProduct = hn::Div(set(1.0), left[kLegCount - 1]);
        for (int i = 0; i < kLegCount; ++i) {
            V inverse = out.inverseProduct;
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
        V sum = hn::Zero(D());
        for (std::size_t i = 0; i < kLegCount; ++i) {
            V b[3], u[3], r[3];
            for (std::size_t k = 0; k < 3; ++k) {
                b[k] = set(machine.joint[k][i]);
                u[k] = hn::Sub(at.c[k], set(machine.base[k][i]));
            }
            for (std::size_t k = 0; k < 3; ++k) {
                r[k] = dot3(R.r[k][0], b[0], R.r[k][1], b[1], R.r[k][2], b[2]);
                rows.d[k][i] = hn::Add(u[k], r[k]);
            }
            rows.m[0][i] = minor(r[1], u[2], r[2], u[1]); // r x d = r x u
            rows.m[1][i] = minor(r[2], u[0], r[0], u[2]);
            rows.m[2][i] = minor(r[0], u[1], r[1], u[0]);
            // |d| (l - |d|) without a root: with t = l^2 - d^2 and u = (t / l^2)
            // it is t/2 (1 - u/4 - u^2/8 - ...); only the last, exact, digits decide, and there u is nothing.
            const V t = hn::Sub(to.l2[i], dot3(rows.d[0][i], rows.d[0][i], rows.d[1][i], rows.d[1][i],
                                               rows.d[2][i], rows.d[2][i]));
            const V part = hn::Mul(t, to.inverse2[i]), half = hn::Mul(t, set(0.5));
            rows.e[i] = hn::Mul(half, hn::NegMulAdd(part, hn::MulAdd(part, set(0.125), set(0.25)), set(1.0)));
            sum = hn::MulAdd(hn::Mul(half, half), to.inverse2[i], sum);
        }
        rows.residual2 = sum;
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
    static HWY_INLINE Step solve(const Rows& rows) {
        V legs[3][3], adjugate1[3][3];
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                legs[i][k] = rows.d[k][i];
        const V det1 = adjugate(legs, adjugate1);
        const V scale1 = hn::Div(set(1.0), det1);
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
        const V scale2 = hn::Div(set(1.0), det2);
        Step step;
        for (int k = 0; k < 3; ++k)
            step.w[k] = hn::Mul(scale2, dot3(adjugate2[k][0], right[0], adjugate2[k][1], right[1],
                                             adjugate2[k][2], right[2]));
        for (int k = 0; k < 3; ++k)
            step.t[k] =
                hn::Mul(scale1, hn::NegMulAdd(mixed[k][0], step.w[0],
                                              hn::NegMulAdd(mixed[k][1], step.w[1],
                                                            hn::NegMulAdd(mixed[k][2], step.w[2], x[k]))));
        step.determinant = hn::Mul(det2, hn::Mul(scale1, scale1)); // det2 was taken of rows times det1
        return step;
    }

    /// The rotation by the Cayley transform of the step: no trigonometry, exact to third order.
    static HWY_INLINE void move(Place& place, const Step& step) {
        for (int k = 0; k < 3; ++k)
            place.c[k] = hn::Add(place.c[k], step.t[k]);
        const V half = set(0.5), w = place.q[0], x = place.q[1], y = place.q[2], z = place.q[3];
        const V hx = hn::Mul(half, step.w[0]), hy = hn::Mul(half, step.w[1]), hz = hn::Mul(half, step.w[2]);
        place.q[0] = hn::NegMulAdd(hx, x, hn::NegMulAdd(hy, y, hn::NegMulAdd(hz, z, w)));
        place.q[1] = hn::MulAdd(hx, w, hn::MulAdd(hy, z, hn::NegMulAdd(hz, y, x)));
        place.q[2] = hn::MulAdd(hy, w, hn::MulAdd(hz, x, hn::NegMulAdd(hx, z, y)));
        place.q[3] = hn::MulAdd(hz, w, hn::MulAdd(hx, y, hn::NegMulAdd(hy, x, z)));
    }

    static HWY_INLINE Step stepFromHome(const LaneMachine& machine, const V* error) {
        V x[kLegCount];
        for (std::size_t i = 0; i < kLegCount; ++i) {
            x[i] = hn::Mul(set(machine.homeInverse[i][0]), error[0]);
            for (std::size_t j = 1; j < kLegCount; ++j)
                x[i] = hn::MulAdd(set(machine.homeInverse[i][j]), error[j], x[i]);
        }
        return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, set(machine.homeDeterminant)};
    }

    static HWY_INLINE V stepSquare(const LaneMachine& machine, const Step& step) {
        const V turn = dot3(step.w[0], step.w[0], step.w[1], step.w[1], step.w[2], step.w[2]);
        return hn::MulAdd(set(machine.spread * machine.spread), turn,
                          dot3(step.t[0], step.t[0], step.t[1], step.t[1], step.t[2], step.t[2]));
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

    /// With an eighth of a turn taken off where that leaves less, so that a short polynomial does; its
    /// numbers interpolate atan(z)/z at the Chebyshev points of 0 <= z^2 <= 0.1716, to 3e-18.
    static HWY_INLINE V atan2(V y, V x) {
        constexpr double kEighth = 0.41421356237309503; // tan(pi/8)
        const V ay = hn::Abs(y), ax = hn::Abs(x), pi = set(std::numbers::pi), zero = hn::Zero(D());
        const V low = hn::Min(ay, ax), high = hn::Max(ay, ax);
        const M far = hn::Gt(low, hn::Mul(set(kEighth), high));
        const V z = hn::Div(hn::IfThenElse(far, hn::Sub(low, high), low),
                            hn::Add(high, hn::IfThenElseZero(far, low)));
        const V z2 = hn::Mul(z, z), z4 = hn::Mul(z2, z2), z8 = hn::Mul(z4, z4);
        const auto pair = [z2](double c0, double c1) HWY_ATTR { return hn::MulAdd(set(c1), z2, set(c0)); };
        const V low4 =
            hn::MulAdd(pair(0.19999999999997009, -0.14285714285329157), z4, pair(1.0, -0.33333333333333326));
        const V mid4 = hn::MulAdd(pair(0.076922810742296691, -0.066662048855676767), z4,
                                  pair(0.11111111085289108, -0.090909080578725016));
        const V high4 = hn::MulAdd(pair(0.044994070991730341, -0.033385655061992529), z4,
                                   pair(0.058768303763903788, -0.052172894049047167));
        const V top = hn::MulAdd(hn::MulAdd(set(0.015111569757496401), z8, high4), z8, mid4);
        V angle =
            hn::MulAdd(z, hn::MulAdd(top, z8, low4), hn::IfThenElseZero(far, set(std::numbers::pi / 4.0)));
        angle = hn::IfThenElse(hn::Gt(ay, ax), hn::Sub(set(std::numbers::pi / 2.0), angle), angle);
        angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(pi, angle), angle);
        angle = hn::CopySign(angle, y);
        return hn::IfThenElse(hn::Le(angle, hn::Neg(pi)), pi, angle); // in (-pi, pi]
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
        pose[4] = atan2(hn::Neg(r[2][0]), hn::Sqrt(cosBeta2));
        if constexpr (kSingle && kHasPairs) {
            const auto outer = Newton<Two>::atan2(pairOf(r[2][1], r[1][0]), pairOf(r[2][2], r[0][0]));
            pose[3] = firstOf(outer);
            pose[5] = secondOf(outer);
        } else {
            pose[3] = atan2(r[2][1], r[2][2]);
            pose[5] = atan2(r[1][0], r[0][0]);
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

/// Sine and cosine up to kShortAngle, by nine terms of their series: the tenth is below 3e-18.
constexpr double kShortAngle = 0.8;
template <class D, class V = hn::Vec<D>>
HWY_INLINE void shortSinCos(D d, V x, V& sine, V& cosine) {
    const V y = hn::Mul(x, x), y2 = hn::Mul(y, y), y4 = hn::Mul(y2, y2), one = hn::Set(d, 1.0);
    const auto series = [=](double c1, double c2, double c3, double c4, double c5, double c6, double c7,
                            double c8) HWY_ATTR {
        const auto pair = [=](double a, double b)
                              HWY_ATTR { return hn::MulAdd(hn::Set(d, b), y, hn::Set(d, a)); };
        const V first = hn::MulAdd(pair(c2, c3), y2, hn::MulAdd(hn::Set(d, c1), y, one));
        const V last = hn::MulAdd(hn::Set(d, c8), y4, hn::MulAdd(pair(c6, c7), y2, pair(c4, c5)));
        return hn::MulAdd(last, y4, first);
    };
    sine = hn::Mul(x, series(-1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0, 1.0 / 362880.0, -1.0 / 39916800.0,
                             1.0 / 6227020800.0, -1.0 / 1307674368000.0, 1.0 / 355687428096000.0));
    cosine = series(-1.0 / 2.0, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40320.0, -1.0 / 3628800.0, 1.0 / 479001600.0,
                    -1.0 / 87178291200.0, 1.0 / 20922789888000.0);
}

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
    run.place.q[1] = N::minor(cc, s[0], ss, c[0]);
    run.place.q[2] = hn::MulAdd(cs, c[0], hn::Mul(sc, s[0]));
    run.place.q[3] = N::minor(sc, c[0], cs, s[0]);
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
