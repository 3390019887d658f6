// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/tracking/workspace_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexapose {

namespace {

constexpr double kGainPerPeriod = 0.25; ///< of an error is taken away in a feedback period at most
constexpr double kLeadOfGap = 1.4;      ///< aim and lead together, of the gap limit
constexpr double kWaitTime = 0.05;      ///< s: the reference takes up a lag in about so long
constexpr double kMostWait = 0.5;       ///< of the path's rate
constexpr double kDriftRange = 1.5;     ///< of the rest distance: a leg that is further off carries a load
constexpr double kDriftTime = 0.15;     ///< s
constexpr double kGapToSlow = 0.5;      ///< of the gap limit: from there on the path slows down

} // namespace

WorkspaceController::WorkspaceController(SharedModel model, const WorkspaceOptions& options)
    : m_model(std::move(model)), m_options(options) {}

void WorkspaceController::begin(const LegLengths& setPoint) {
    m_aim = m_setPoint = setPoint;
    m_pathRate = 1.0;
    m_lagEstimator.interrupt();
}

/// The largest part of the feed-forward rates that leaves every leg within its speed: they and the correction
/// add up.
double WorkspaceController::allowedRate(const LegLengths& feedForward, const LegLengths& correction) const {
    double rate = 1.0;
    for (int leg = 0; leg < kLegCount; ++leg) {
        const double toward = feedForward[leg] >= 0.0 ? correction[leg] : -correction[leg];
        const double size = std::abs(feedForward[leg]);
        if (size > 0.0)
            rate = std::min(rate, std::max((m_options.legSpeed - toward) / size, 0.0));
    }
    return rate;
}

/// What is left of an error at rest is within the rounding of the measurement. Without a load on the legs the
/// lengths of the reference are nearer to the truth than what is measured.
void WorkspaceController::driftToRest(const LegLengths& end, double seconds) {
    const LegLengths left = end - m_aim;
    const double largest = left.cwiseAbs().maxCoeff();
    if (largest > 0.0 && largest <= kDriftRange * m_options.restDistance)
        m_aim += std::min(seconds / kDriftTime, 1.0) * left;
}

/// How long the platform is behind the reference along its twist, s; turning counts as the joints move by it.
double WorkspaceController::lagOf(const Twist& error, const Twist& twist) const {
    const double arm = m_model->jointRadius() * m_model->jointRadius();
    const double square = twist.head<3>().squaredNorm() + arm * twist.tail<3>().squaredNorm();
    const double along = error.head<3>().dot(twist.head<3>()) + arm * error.tail<3>().dot(twist.tail<3>());
    return square > 0.0 ? along / square : 0.0;
}

WorkspaceController::Step WorkspaceController::step(const Measurement& measured,
                                                    const PoseReference& reference, Following following,
                                                    double wantedRate, const MotionLimits& limits) {
    m_lagEstimator.add(m_setPoint, measured.lengths, measured.seconds);
    Step step{};
    step.error = displacement(measured.pose, reference.pose);
    // On a path the part of the error along it is not the legs' to make good: the reference waits instead.
    const double lag = following == Following::Path ? lagOf(step.error, reference.twist) : 0.0;
    const Twist toCorrect = step.error - lag * reference.twist;
    const double gain = std::min(m_options.gain, kGainPerPeriod / std::max(measured.seconds, 1e-6));
    const Jacobian J = m_model->jacobian(measured.pose);
    const LegLengths feedForward = J * reference.twist;
    const bool rests = reference.twist.isZero(0.0) && step.error.head<3>().norm() <= m_options.restDistance &&
                       step.error.tail<3>().norm() <= m_options.restAngle;
    LegLengths correction = rests ? LegLengths(LegLengths::Zero()) : LegLengths(gain * (J * toCorrect));
    // A correction alone may ask for more than the legs can: then all of it is scaled.
    const double largest = correction.cwiseAbs().maxCoeff();
    if (largest > m_options.legSpeed) {
        correction *= m_options.legSpeed / largest;
        step.saturated = true;
    }

    const double gap = (m_aim - measured.lengths).cwiseAbs().maxCoeff() / m_options.gapLimit;
    double rate = std::min({wantedRate, allowedRate(feedForward, correction),
                            std::clamp((1.0 - gap) / (1.0 - kGapToSlow), 0.0, 1.0)});
    step.saturated = step.saturated || rate < wantedRate;
    // Slower at once, faster little by little.
    rate = std::min(rate, m_pathRate + measured.seconds / m_options.speedUpTime);
    m_pathRate = rate;
    step.pathRate = rate * (1.0 - std::clamp(lag / kWaitTime, -kMostWait, kMostWait));

    const LegLengths rates = rate * feedForward + correction;
    m_aim += measured.seconds * rates;
    if (rests)
        driftToRest(m_model->actuators(reference.pose), measured.seconds);
    const LegLengths ahead = m_aim - measured.lengths;
    const double tooFar = ahead.cwiseAbs().maxCoeff() / m_options.gapLimit;
    if (tooFar > 1.0)
        m_aim = measured.lengths + ahead / tooFar;
    // A leg at the end of its stroke gives what it can; the lead there is not needed for long.
    const LegLengths aim = m_aim.cwiseMax(limits.minLength).cwiseMin(limits.maxLength);
    step.saturated = step.saturated || aim != m_aim;
    m_aim = aim;
    LegLengths lead = aim + m_lagEstimator.lags().cwiseProduct(rates) - measured.lengths;
    const double furthest = lead.cwiseAbs().maxCoeff() / (kLeadOfGap * m_options.gapLimit);
    if (furthest > 1.0)
        lead /= furthest;
    m_setPoint = (measured.lengths + lead).cwiseMax(limits.minLength).cwiseMin(limits.maxLength);
    step.setPoint = m_setPoint;
    return step;
}

} // namespace hexapose
