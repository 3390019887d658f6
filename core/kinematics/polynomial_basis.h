// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"

namespace hexapose {

inline constexpr int kMinDegree = 1;
inline constexpr int kMaxDegree = 4;

/// n over k.
constexpr int binomial(int n, int k) {
    int result = 1;
    for (int i = 1; i <= k; ++i)
        result = result * (n - k + i) / i;
    return result;
}

/// Distinct monomials of six variables up to a degree: 7, 28, 84, 210.
constexpr int monomialCount(int degree) {
    return binomial(kLegCount + degree, kLegCount);
}

inline constexpr int kMaxMonomials = monomialCount(kMaxDegree);

/// Builds the monomials in their order, degree by degree. The monomials of degree d that end in variable k
/// are u_k times those of degree d-1 in the variables 0 to k, which stand side by side: each is one product
/// of an earlier one, and they come in runs. Calls run(k, first parent, first child, count) for each;
/// monomial 0 is 1.
template <class Run>
constexpr void forEachMonomialRun(int degree, Run&& run) {
    int parents = 0, child = 1;
    for (int d = 1; d <= degree; ++d) {
        const int next = child;
        for (int k = 0; k < kLegCount; ++k) {
            const int count = binomial(d - 1 + k, k);
            run(k, parents, child, count);
            child += count;
        }
        parents = next;
    }
}

} // namespace hexapose
