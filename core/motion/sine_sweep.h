// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/pose_motion.h"

#include <optional>

namespace hexapose {

/// A sine about a pose along one axis of the base frame, its frequency rising or falling evenly in time. The
/// amplitude swells at the start and dies away at the end, so that it begins and ends at rest at the centre.
struct SweepSettings {
    int axis = 0;                ///< 0..2: along x, y, z; 3..5: about x, y, z
    double amplitude = 0.0;      ///< m or rad, above zero
    double startFrequency = 0.1; ///< Hz, not below zero
    double endFrequency = 1.0;   ///< Hz, not below zero
    double seconds = 10.0;       ///< of the whole motion, above zero
};

enum class SweepFault { NoSuchAxis, Amplitude, Frequency, Duration };

/// Which of the settings cannot be used; nothing when all can.
std::optional<SweepFault> faultOf(const SweepSettings& settings);

class SineSweep final : public PoseMotion {
public:
    SineSweep(const Pose& centre, const SweepSettings& settings);

    PoseReference at(double seconds) const override;
    double duration() const override { return m_settings.seconds; }
    RateBounds rateBounds(const Eigen::Vector3d& p_PC_P) const override;

private:
    Pose m_centre;
    SweepSettings m_settings;
    double m_fastest; ///< of the swinging coordinate, m/s or rad/s
    double m_hardest; ///< its acceleration, m/s^2 or rad/s^2
};

} // namespace hexapose
