// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"

#include <array>
#include <cstddef>

namespace hexapose {

inline constexpr int kMaxDegree = 4;
inline constexpr std::size_t kMaxMonomials = 210;

/// Number of distinct monomials in six variables up to a degree: 7, 28, 84, 210 for degree 1 to 4.
constexpr std::size_t monomialCount(int degree) {
    std::size_t count = 1;
    for (int k = 1; k <= degree; ++k)
        count = count * static_cast<std::size_t>(kLegCount + k) / static_cast<std::size_t>(k);
    return count;
}

/// How each monomial comes from an earlier one: value = value of `parent` times variable `variable`. Monomial
/// 0 is 1. By degree, and within a degree by parent and rising variable, so that every product stands here
/// once.
struct MonomialTable {
    std::array<unsigned char, kMaxMonomials> parent{};
    std::array<unsigned char, kMaxMonomials> variable{};
};

constexpr MonomialTable makeMonomialTable() {
    MonomialTable table;
    std::size_t next = 1;
    std::size_t degreeBegin = 0;
    for (int degree = 1; degree <= kMaxDegree; ++degree) {
        const std::size_t degreeEnd = next;
        for (std::size_t parent = degreeBegin; parent < degreeEnd; ++parent) {
            const std::size_t first = parent == 0 ? 0 : table.variable[parent];
            for (std::size_t variable = first; variable < static_cast<std::size_t>(kLegCount); ++variable) {
                table.parent[next] = static_cast<unsigned char>(parent);
                table.variable[next] = static_cast<unsigned char>(variable);
                ++next;
            }
        }
        degreeBegin = degreeEnd;
    }
    return table;
}

inline constexpr MonomialTable kMonomials = makeMonomialTable();

/// The first `count` monomials of u.
inline void fillMonomials(const LegVector& u, std::size_t count, double* values) noexcept {
    values[0] = 1.0;
    for (std::size_t i = 1; i < count; ++i)
        values[i] = values[kMonomials.parent[i]] * u[kMonomials.variable[i]];
}

} // namespace hexapose
