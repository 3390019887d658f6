// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/kinematics/extreme_singular_values.h"

#include "core/geometry/singular_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace hexapose {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Pair = Eigen::Array2d; ///< both ends of the spectrum at once

constexpr double kOrder = 6.0;
/// Relative to the trace: an eigenvalue counts as known.
constexpr double kResolution = 4e-15;
/// Ratio of the eigenvalues of M^T M below which the root of the smallest is not accurate enough any more.
constexpr double kLeastRatio = 3e-5;
constexpr double kApart = 1.05;      ///< largest over smallest eigenvalue
constexpr int kMostSteps = 32;       ///< 5 to 9 are taken
constexpr double kDoubleRoot = 0.2;  ///< (p'/p)^2 over its own slope is so near to 2
constexpr double kCrowd = 2.5;       ///< it is more, where a root counts as near,
constexpr double kNearRoot = 1e-3;   ///< relative to the trace
constexpr double kNextToRoot = 1e-6; ///< and what is counted is rounding where it is so near to one of two
/// So near to a root, relative to the trace, the next step of third order ends at it.
constexpr double kLastStep = 1e-6;

/// A symmetric tridiagonal matrix: its diagonal, and the squares beside it.
struct Tridiagonal {
    std::array<double, 6> diagonal;
    std::array<double, 5> squares;
};

constexpr std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Householder's reflection of column K, applied from both sides. Of the symmetric matrix only the lower half
/// is used; that the size is known to the compiler makes it twice as fast.
template <int K>
void reflect(Matrix6& a, Tridiagonal& t) {
    constexpr int kSize = 5 - K;
    std::array<double, at(kSize)> x, u, p;
    for (int i = 0; i < kSize; ++i)
        x[at(i)] = a(K + 1 + i, K);
    double below = 0.0;
    for (int i = 1; i < kSize; ++i)
        below += x[at(i)] * x[at(i)];
    const double square = x[0] * x[0] + below;
    t.squares[at(K)] = square;
    if (!(below > 0.0))
        return;
    // The vector is v = x + s e_0. With s apart, most is computed while its root is.
    const auto element = [&a](int i, int j) { return a(K + 1 + std::max(i, j), K + 1 + std::min(i, j)); };
    double xu = 0.0;
    for (int i = 0; i < kSize; ++i) {
        u[at(i)] = element(i, 0) * x[0];
        for (int j = 1; j < kSize; ++j)
            u[at(i)] += element(i, j) * x[at(j)];
        xu += u[at(i)] * x[at(i)];
    }
    const double s = std::copysign(std::sqrt(square), x[0]);
    const double scale = 1.0 / (square + x[0] * s); // 2 / (v . v)
    const double product = xu + s * (2.0 * u[0] + s * element(0, 0));
    const double half = 0.5 * scale * scale * product;
    x[0] += s;
    for (int i = 0; i < kSize; ++i)
        p[at(i)] = scale * (u[at(i)] + s * element(i, 0)) - half * x[at(i)];
    for (int i = 0; i < kSize; ++i)
        for (int j = 0; j <= i; ++j)
            a(K + 1 + i, K + 1 + j) -= x[at(i)] * p[at(j)] + p[at(i)] * x[at(j)];
}

/// The same for the last column, of two elements: a rotation, which takes no root.
void rotateLast(Matrix6& a, Tridiagonal& t) {
    const double c = a(4, 3), s = a(5, 3);
    t.squares[3] = c * c + s * s;
    if (s != 0.0) {
        const double scale = 1.0 / t.squares[3];
        const double cc = scale * c * c, cs = scale * c * s, ss = scale * s * s;
        const double first = a(4, 4), last = a(5, 5), beside = a(5, 4);
        a(4, 4) = cc * first + 2.0 * cs * beside + ss * last;
        a(5, 5) = ss * first - 2.0 * cs * beside + cc * last;
        a(5, 4) = (cc - ss) * beside + cs * (last - first);
    }
    t.squares[4] = a(5, 4) * a(5, 4);
}

Tridiagonal tridiagonal(Matrix6 a) {
    Tridiagonal t;
    reflect<0>(a, t);
    reflect<1>(a, t);
    reflect<2>(a, t);
    rotateLast(a, t);
    for (int i = 0; i < 6; ++i)
        t.diagonal[at(i)] = a(i, i);
    return t;
}

/// What Laguerre's method asks of the characteristic polynomials p of T and -T, one in each lane.
struct Laguerre {
    Pair value;   ///< p
    Pair least;   ///< smallest of the leading minors: positive exactly below the smallest root (Sylvester)
    Pair single;  ///< step that ends short of the smallest root, or beyond it comes back to it
    Pair twofold; ///< the same for a double root
    Pair most;    ///< step that does not end short of it
    Pair isDouble;
    Pair isCrowded; ///< more than two roots are about as near
};

Laguerre laguerreAt(const Tridiagonal& t, const Pair& x) {
    const Pair sign(1.0, -1.0);
    Pair p2 = Pair::Ones(), q2 = Pair::Zero(), r2 = Pair::Zero(); // p, -p' and p'' of the minor before last
    Pair p1 = sign * t.diagonal[0] - x, q1 = Pair::Ones(), r1 = Pair::Zero();
    Laguerre result;
    result.least = p1;
    for (std::size_t i = 1; i < 6; ++i) {
        const Pair d = sign * t.diagonal[i] - x;
        const double e = t.squares[i - 1];
        const Pair p = d * p1 - e * p2;
        const Pair q = d * q1 + (p1 - e * q2); // what waits for the minor before, last
        const Pair r = d * r1 + (2.0 * q1 - e * r2);
        p2 = p1, q2 = q1, r2 = r1;
        p1 = p, q1 = q, r1 = r;
        result.least = result.least.min(p);
    }
    const Pair qq = q1 * q1;
    const Pair w = qq - p1 * r1;
    const Pair root = ((kOrder - 1.0) * qq - kOrder * p1 * r1).max(0.0).sqrt();
    result.value = p1;
    result.single = kOrder * p1 / (q1 + std::sqrt(kOrder - 1.0) * root);
    result.twofold = kOrder * p1 / (q1 + std::sqrt(0.5 * kOrder - 1.0) * root);
    result.most = q1 * p1 / w;
    result.isCrowded = (qq > kCrowd * w).cast<double>();
    result.isDouble = ((qq - 2.0 * w).abs() < kDoubleRoot * w).cast<double>();
    return result;
}

/// Smallest and largest eigenvalue, between bounds that close in on them from both sides. Not for more than
/// two that are nearly the same: nothing then.
std::optional<Pair> extremeEigenvalues(const Tridiagonal& t) {
    double sum = 0.0, squares = 0.0;
    for (const double d : t.diagonal)
        sum += d, squares += d * d;
    for (const double e : t.squares)
        squares += 2.0 * e;
    const double mean = sum / kOrder;
    const double deviation =
        std::sqrt(std::max(0.0, (kOrder - 1.0) / kOrder * (squares - kOrder * mean * mean)));
    const double resolution = kResolution * sum;
    Pair x(0.0, -(mean + deviation) * (1.0 + 1e-12));
    Pair lower = x, upper(mean, -mean);
    for (int step = 0; step < kMostSteps; ++step) {
        const Laguerre here = laguerreAt(t, x);
        bool known = true;
        for (int end = 0; end < 2; ++end) {
            if (here.isCrowded[end] != 0.0 && here.single[end] < kNearRoot * sum &&
                here.single[end] > kNextToRoot * sum)
                return std::nullopt; // its minors are lost in rounding before the root is known
            if (here.least[end] > 0.0) {
                lower[end] = x[end] + here.single[end];
                upper[end] = std::min(upper[end], x[end] + here.most[end]);
                const double further = x[end] + here.twofold[end];
                x[end] = here.isDouble[end] != 0.0 && further < upper[end] ? further : lower[end];
            } else {
                upper[end] = std::min(upper[end], x[end]);
                const double back = x[end] + here.single[end];
                if (here.value[end] < 0.0 && back > lower[end] && back < upper[end]) { // one root below
                    const bool last = upper[end] - back < kLastStep * sum;
                    upper[end] = back;
                    x[end] = last ? std::max(lower[end], back - 0.75 * resolution) : back;
                } else {
                    x[end] = lower[end];
                }
            }
            known = known && upper[end] - lower[end] <= resolution;
        }
        if (known)
            return Pair(lower[0], -lower[1]);
    }
    return std::nullopt;
}

} // namespace

std::optional<ExtremeSingularValues> fastExtremeSingularValues(const Matrix6& matrix) noexcept {
    const auto values = extremeEigenvalues(tridiagonal(matrix.transpose().lazyProduct(matrix)));
    const bool apart =
        values && (*values)[1] > kApart * (*values)[0]; // else the polynomial knows them too little
    if (apart && (*values)[0] > kLeastRatio * (*values)[1])
        return ExtremeSingularValues{std::sqrt((*values)[0]), std::sqrt((*values)[1])};
    return std::nullopt;
}

ExtremeSingularValues extremeSingularValues(const Matrix6& matrix) noexcept {
    if (const auto fast = fastExtremeSingularValues(matrix))
        return *fast;
    const auto all = singularValues(matrix);
    return {all[5], all[0]};
}

} // namespace hexapose
