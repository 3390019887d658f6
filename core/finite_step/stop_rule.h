// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace hexapose {

/// Tells when a path comes too near to a singular pose to be followed (Front. Mech. Eng. 2025, 20(1):7,
/// section 4), from the signed ratio q of the step matrix's determinant to that at home. The sign alone does
/// not tell: a path that meets a fold bounces off to the twin pose of the same lengths, and q comes back.
class StopRule {
public:
    /// Steps in all, and q where the path begins.
    StopRule(int steps, double q) noexcept
        : m_floor(1.0 / std::sqrt(static_cast<double>(steps))), m_last(q) {}

    /// Whether to stop where q is this; NaN stops.
    bool stops(double q) noexcept {
        const double change = std::abs(q - m_last);
        m_last = q;
        return !(q > 0.0 && q >= m_floor && q >= kLookAhead * change);
    }

private:
    static constexpr double kLookAhead = 5.0; ///< steps at this pace to q = 0
    double m_floor;
    double m_last;
};

} // namespace hexapose
