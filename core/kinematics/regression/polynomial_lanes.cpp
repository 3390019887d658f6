// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Compiled once for each kind of vector unit; the one for this processor is chosen when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kinematics/regression/polynomial_lanes.cpp"
#include "core/kinematics/regression/polynomial_lanes.h"
#include "core/kinematics/regression/polynomial_basis.h"
#include "core/kinematics/vector/lane_targets.h"

#include <hwy/foreach_target.h>
// The targets first.
#include <hwy/highway.h>

#include <array>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace hexapose {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kOutputs = 6;
constexpr std::size_t kStride = 8; ///< from the coefficients of a monomial to those of the next

/// Horner's scheme over six variables: a monomial that ends in variable k is followed by those that have one
/// more variable, 0 to k, which is also their order in memory, degree by degree. One multiplication and
/// addition a monomial, and no table of monomials.
template <class D, int kDegree>
struct Horner {
    using V = hn::Vec<D>;
    std::array<const double*, static_cast<std::size_t>(kDegree) + 1>
        next; ///< coefficients of each degree that were not used yet
    V u[kLegCount];

    HWY_INLINE Horner(const double* variables, const double* coefficients) {
        for (int degree = 0, first = 0; degree <= kDegree; first = monomialCount(degree++))
            next[static_cast<std::size_t>(degree)] = coefficients + kStride * static_cast<std::size_t>(first);
        for (int k = 0; k < kLegCount; ++k)
            u[k] = hn::Set(D(), variables[k]);
    }

    template <int kThis, int kLast>
    HWY_INLINE V term() {
        V sum = hn::Load(D(), std::get<kThis>(next));
        std::get<kThis>(next) += kStride;
        if constexpr (kThis < kDegree)
            sum = terms<kThis>(sum, std::make_integer_sequence<int, kLast + 1>());
        return sum;
    }

    template <int kThis, int... kVariables>
    HWY_INLINE V terms(V sum, std::integer_sequence<int, kVariables...>) {
        ((sum = hn::MulAdd(u[kVariables], term<kThis + 1, kVariables>(), sum)), ...);
        return sum;
    }
};

template <class D, int kDegree>
HWY_INLINE void evaluatePart(const double* variables, const double* coefficients, double* values) {
    Horner<D, kDegree> horner(variables, coefficients);
    const auto sum = horner.template term<0, kLegCount - 1>();
    if constexpr (hn::MaxLanes(D()) > kOutputs)
        hn::BlendedStore(sum, hn::FirstN(D(), kOutputs), D(), values);
    else
        hn::StoreU(sum, D(), values);
}

template <int kDegree>
void evaluateDegree(const double* variables, const double* coefficients, double* values) {
    using Eight = hn::CappedTag<double, 8>;
    using Four = hn::CappedTag<double, 4>;
    using Two = hn::CappedTag<double, 2>;
    if constexpr (hn::MaxLanes(Eight()) == 8) {
        evaluatePart<Eight, kDegree>(variables, coefficients, values);
    } else if constexpr (hn::MaxLanes(Four()) == 4) {
        evaluatePart<Four, kDegree>(variables, coefficients, values);
        evaluatePart<Two, kDegree>(variables, coefficients + 4, values + 4);
    } else {
        for (std::size_t i = 0; i < kOutputs; i += hn::MaxLanes(Two()))
            evaluatePart<Two, kDegree>(variables, coefficients + i, values + i);
    }
}

void evaluate(int degree, const double* variables, const double* coefficients, double* values) {
    switch (degree) {
    case 1:
        return evaluateDegree<1>(variables, coefficients, values);
    case 2:
        return evaluateDegree<2>(variables, coefficients, values);
    case 3:
        return evaluateDegree<3>(variables, coefficients, values);
    default:
        return evaluateDegree<4>(variables, coefficients, values);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace hexapose
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hexapose {

HWY_EXPORT(evaluate);

void evaluatePolynomials(int degree, const double* variables, const double* coefficients,
                         double* values) noexcept {
    HWY_DYNAMIC_DISPATCH(evaluate)(degree, variables, coefficients, values);
}

} // namespace hexapose
#endif
