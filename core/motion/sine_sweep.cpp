// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/sine_sweep.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hexapose {

namespace {

using std::numbers::pi;

constexpr double kSwell = 0.15; ///< of the whole time, at each end

struct Valued {
    double value;
    double rate;
};

/// 0 to 1 to 0, smooth to the second derivative.
Valued envelope(double part) {
    const double place = std::min(part, 1.0 - part) / kSwell;
    const double sign = part < 0.5 ? 1.0 : -1.0;
    if (place >= 1.0)
        return {1.0, 0.0};
    const double u = std::max(place, 0.0);
    return {u * u * u * (10.0 + u * (-15.0 + 6.0 * u)), sign * 30.0 * u * u * (1.0 - u) * (1.0 - u) / kSwell};
}

} // namespace

std::optional<SweepFault> faultOf(const SweepSettings& settings) {
    if (settings.axis < 0 || settings.axis > 5)
        return SweepFault::NoSuchAxis;
    if (!(settings.amplitude > 0.0) || !std::isfinite(settings.amplitude))
        return SweepFault::Amplitude;
    if (!(settings.startFrequency >= 0.0) || !(settings.endFrequency >= 0.0) ||
        !std::isfinite(settings.startFrequency + settings.endFrequency))
        return SweepFault::Frequency;
    if (!(settings.seconds > 0.0) || !std::isfinite(settings.seconds))
        return SweepFault::Duration;
    return std::nullopt;
}

SineSweep::SineSweep(const Pose& centre, const SweepSettings& settings)
    : m_centre(centre), m_settings(settings) {
    // The envelope w rises by at most 15/8 of its mean slope, and its slope by 10/sqrt(3) of that of a
    // parabola.
    const double swell = kSwell * settings.seconds;
    const double w1 = 1.875 / swell, w2 = 5.7736 / (swell * swell);
    const double phase1 = 2.0 * pi * std::max(settings.startFrequency, settings.endFrequency);
    const double phase2 =
        2.0 * pi * std::abs(settings.endFrequency - settings.startFrequency) / settings.seconds;
    // (w sin)' = w' sin + w phase' cos, and so on
    m_fastest = settings.amplitude * (w1 + phase1);
    m_hardest = settings.amplitude * (w2 + 2.0 * w1 * phase1 + phase2 + phase1 * phase1);
}

RateBounds SineSweep::rateBounds(const Eigen::Vector3d& p_PC_P) const {
    if (m_settings.axis < 3)
        return {m_fastest, m_hardest, 0.0, 0.0};
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(m_settings.axis - 3);
    const double arm = axis.cross(rotationMatrix(m_centre.angles) * p_PC_P).norm();
    return {arm * m_fastest, arm * (m_hardest + m_fastest * m_fastest), m_fastest, m_hardest};
}

PoseReference SineSweep::at(double seconds) const {
    const double T = m_settings.seconds;
    const double t = std::clamp(seconds, 0.0, T);
    const double slope = (m_settings.endFrequency - m_settings.startFrequency) / T;
    const double phase = 2.0 * pi * t * (m_settings.startFrequency + 0.5 * slope * t);
    const double phaseRate = 2.0 * pi * (m_settings.startFrequency + slope * t);
    const Valued swell = envelope(t / T);
    Twist unit = Twist::Zero();
    unit[m_settings.axis] = m_settings.amplitude;
    const double value = swell.value * std::sin(phase);
    const double rate = swell.rate / T * std::sin(phase) + swell.value * phaseRate * std::cos(phase);
    return {displaced(m_centre, value * unit), rate * unit};
}

} // namespace hexapose
