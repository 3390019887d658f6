// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"

#include <array>
#include <cstddef>

namespace hexapose {

/// Degrees of a regression.
inline constexpr int kMinDegree = 1;
inline constexpr int kMaxDegree = 4;

/// n over k.
constexpr int binomial(int n, int k) {
    int result = 1;
    for (int i = 1; i <= k; ++i)
        result = result * (n - k + i) / i;
    return result;
}

/// Distinct monomials of six variables up to a degree, the terms of Eq. 16: 7, 28, 84, 210.
constexpr int monomialCount(int degree) {
    return binomial(kLegCount + degree, kLegCount);
}

inline constexpr int kMaxMonomials = monomialCount(kMaxDegree);

/// Neighbouring monomials that are each one variable times an earlier monomial.
struct MonomialRun {
    int variable;
    int parent; ///< first of the earlier ones
    int child;  ///< first of these
    int count;
};

/// How the monomials are built, degree by degree, from monomial 0, which is 1. Those of degree d that end in
/// variable k are u_k times those of degree d-1 in the variables 0 to k, which stand side by side. Six runs a
/// degree.
constexpr std::array<MonomialRun, kMaxDegree * kLegCount> monomialRuns() {
    std::array<MonomialRun, kMaxDegree * kLegCount> runs{};
    int parents = 0, child = 1;
    std::size_t n = 0;
    for (int d = 1; d <= kMaxDegree; ++d) {
        const int next = child;
        for (int k = 0; k < kLegCount; ++k) {
            runs[n] = {k, parents, child, binomial(d - 1 + k, k)};
            child += runs[n++].count;
        }
        parents = next;
    }
    return runs;
}

inline constexpr auto kMonomialRuns = monomialRuns();

/// Calls run(variable, parent, child, count) for each run up to a degree.
template <class Run>
constexpr void forEachMonomialRun(int degree, Run&& run) {
    for (std::size_t n = 0; n < static_cast<std::size_t>(degree) * static_cast<std::size_t>(kLegCount); ++n)
        run(kMonomialRuns[n].variable, kMonomialRuns[n].parent, kMonomialRuns[n].child,
            kMonomialRuns[n].count);
}

} // namespace hexapose
