// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/control/workspace_controller.h"

#include "core/kinematics/jacobian.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kGainPerPeriod = 0.25; ///< of an error is taken away in a feedback period at most
constexpr double kGapToSlow = 0.5;      ///< of the gap limit: from there on the path slows down

} // namespace

WorkspaceController::WorkspaceController(const PlatformGeometry& geometry, const WorkspaceOptions& options)
    : m_geometry(geometry), m_options(options) {}

void WorkspaceController::begin(const LegLengths& setPoint) {
    m_aim = m_setPoint = setPoint;
    m_pathRate = 1.0;
    m_lagEstimator.interrupt();
}

/// The largest part of the feed that leaves every leg within its speed: feed and correction add up.
double WorkspaceController::allowedRate(const LegLengths& feed, const LegLengths& correction) const {
    double rate = 1.0;
    for (int leg = 0; leg < kLegCount; ++leg) {
        const double toward = feed[leg] >= 0.0 ? correction[leg] : -correction[leg];
        const double size = std::abs(feed[leg]);
        if (size > 0.0)
            rate = std::min(rate, std::max((m_options.legSpeed - toward) / size, 0.0));
    }
    return rate;
}

WorkspaceController::Step WorkspaceController::step(const Measurement& measured, const PoseReference& reference,
                                                    double wantedRate, const MotionLimits& limits) {
    m_lagEstimator.add(m_setPoint, measured.lengths, measured.seconds);
    Step step{};
    step.error = displacement(measured.pose, reference.pose);
    const double gain = std::min(m_options.gain, kGainPerPeriod / std::max(measured.seconds, 1e-6));
    const Jacobian J = geometricJacobian(m_geometry, measured.pose);
    const LegLengths feed = J * reference.twist;
    const bool rests = reference.twist.isZero(0.0) && step.error.head<3>().norm() <= m_options.restDistance &&
                       step.error.tail<3>().norm() <= m_options.restAngle;
    LegLengths correction = rests ? LegLengths(LegLengths::Zero()) : LegLengths(gain * (J * step.error));
    // A correction alone may ask for more than the legs can: then all of it is scaled.
    const double largest = correction.cwiseAbs().maxCoeff();
    if (largest > m_options.legSpeed) {
        correction *= m_options.legSpeed / largest;
        step.saturated = true;
    }

    const double gap = (m_aim - measured.lengths).cwiseAbs().maxCoeff() / m_options.gapLimit;
    double rate = std::min({wantedRate, allowedRate(feed, correction),
                            std::clamp((1.0 - gap) / (1.0 - kGapToSlow), 0.0, 1.0)});
    step.saturated = step.saturated || rate < wantedRate;
    // Slower at once, faster little by little.
    rate = std::min(rate, m_pathRate + measured.seconds / m_options.speedUpTime);
    m_pathRate = step.pathRate = rate;

    const LegLengths rates = rate * feed + correction;
    m_aim += measured.seconds * rates;
    const LegLengths ahead = m_aim - measured.lengths;
    const double tooFar = ahead.cwiseAbs().maxCoeff() / m_options.gapLimit;
    if (tooFar > 1.0)
        m_aim = measured.lengths + ahead / tooFar;
    // A leg at the end of its stroke gives what it can; the lead there is not needed for long.
    const LegLengths aim = m_aim.cwiseMax(limits.minLength).cwiseMin(limits.maxLength);
    step.saturated = step.saturated || aim != m_aim;
    m_aim = aim;
    m_setPoint = (aim + m_lagEstimator.lags().cwiseProduct(rates)).cwiseMax(limits.minLength).cwiseMin(limits.maxLength);
    step.setPoint = m_setPoint;
    return step;
}

} // namespace hexapose
