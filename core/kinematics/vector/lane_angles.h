// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Sines, cosines and arc tangents by short polynomials; included once for each kind of vector unit.
#if defined(HEXAPOSE_LANE_ANGLES) == defined(HWY_TARGET_TOGGLE)
#ifdef HEXAPOSE_LANE_ANGLES
#undef HEXAPOSE_LANE_ANGLES
#else
#define HEXAPOSE_LANE_ANGLES
#endif

#include <hwy/highway.h>

#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace hexapose {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// With an eighth of a turn taken off where that leaves less, so that a short polynomial does; its
/// numbers interpolate atan(z)/z at the Chebyshev points of 0 <= z^2 <= 0.1716, to 3e-18.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V arcTangent(D d, V y, V x) {
    const auto set = [d](double value) HWY_ATTR { return hn::Set(d, value); };
    constexpr double kEighth = 0.41421356237309503; // tan(pi/8)
    const V ay = hn::Abs(y), ax = hn::Abs(x), pi = set(std::numbers::pi), zero = hn::Zero(d);
    const V low = hn::Min(ay, ax), high = hn::Max(ay, ax);
    const auto far = hn::Gt(low, hn::Mul(set(kEighth), high));
    const V z =
        hn::Div(hn::IfThenElse(far, hn::Sub(low, high), low), hn::Add(high, hn::IfThenElseZero(far, low)));
    const V z2 = hn::Mul(z, z), z4 = hn::Mul(z2, z2), z8 = hn::Mul(z4, z4);
    const auto pair = [&](double c0, double c1) HWY_ATTR { return hn::MulAdd(set(c1), z2, set(c0)); };
    const V low4 =
        hn::MulAdd(pair(0.19999999999997009, -0.14285714285329157), z4, pair(1.0, -0.33333333333333326));
    const V mid4 = hn::MulAdd(pair(0.076922810742296691, -0.066662048855676767), z4,
                              pair(0.11111111085289108, -0.090909080578725016));
    const V high4 = hn::MulAdd(pair(0.044994070991730341, -0.033385655061992529), z4,
                               pair(0.058768303763903788, -0.052172894049047167));
    const V top = hn::MulAdd(hn::MulAdd(set(0.015111569757496401), z8, high4), z8, mid4);
    V angle = hn::MulAdd(z, hn::MulAdd(top, z8, low4), hn::IfThenElseZero(far, set(std::numbers::pi / 4.0)));
    angle = hn::IfThenElse(hn::Gt(ay, ax), hn::Sub(set(std::numbers::pi / 2.0), angle), angle);
    angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(pi, angle), angle);
    angle = hn::CopySign(angle, y);
    return hn::IfThenElse(hn::Le(angle, hn::Neg(pi)), pi, angle); // in (-pi, pi]
}

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

} // namespace
} // namespace HWY_NAMESPACE
} // namespace hexapose
HWY_AFTER_NAMESPACE();
#endif
