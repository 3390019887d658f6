// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

namespace hexapose {

/// A part of full speed that follows what is asked for without a jump: from 0 to 1 in a quarter of a second.
/// A motion begins with what is asked for then, as it begins from rest.
class SpeedRamp {
public:
    double step(double wanted, double seconds) {
        constexpr double kWhole = 0.25; ///< s
        const double speed = m_speed.value_or(wanted);
        m_speed = speed + std::clamp(wanted - speed, -seconds / kWhole, seconds / kWhole);
        return *m_speed;
    }

private:
    std::optional<double> m_speed;
};

} // namespace hexapose
