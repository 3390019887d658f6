// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/console/synthetic_machine.h"

#include "core/base/units.h"
#include "core/geometry/geometry_file.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/machine/machine_state.h"

namespace hexapose::testing {

namespace {
constexpr std::chrono::milliseconds kPeriod{10}; // of the controller's feedback
}

PlatformGeometry laboratoryPlatform() {
    return loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
}

std::shared_ptr<const ForwardSolver> newtonSolver(const PlatformGeometry& geometry) {
    return std::make_shared<NewtonRaphson>(geometry, NewtonOptions{});
}

Pose poseOf(double xMm, double yMm, double zMm, double alphaDeg, double betaDeg, double gammaDeg) {
    return {{metresFromMm(xMm), metresFromMm(yMm), metresFromMm(zMm)},
            {radiansFromDeg(alphaDeg), radiansFromDeg(betaDeg), radiansFromDeg(gammaDeg)}};
}

Snapshot snapshotAt(const PlatformGeometry& geometry, const Pose& measured, const Pose& target,
                    RunState state, double time) {
    Snapshot snapshot;
    snapshot.time = std::chrono::nanoseconds(static_cast<std::int64_t>(time * 1e9));
    snapshot.wallTime = std::chrono::system_clock::now();
    snapshot.state = state;
    snapshot.link = LinkState::Connected;
    snapshot.allowed = allowedCommands({.run = state, .hasControl = true});
    snapshot.fresh = true;
    snapshot.stale = false;
    snapshot.age = std::chrono::milliseconds(4);
    snapshot.measuredLengths = legLengths(geometry, measured);
    snapshot.commandedLengths = legLengths(geometry, target);
    snapshot.measuredPose = measured;
    snapshot.targetPose = target;
    snapshot.goalPose = target;
    snapshot.status = SolveStatus::Converged;
    snapshot.iterations = 2;
    snapshot.residual = 3e-13;
    snapshot.feedbackRate = 100.0;
    return snapshot;
}

void InstantDevice::write(const SetPoints& setPoints) {
    switch (setPoints.request) {
    case DeviceRequest::Reference:
    case DeviceRequest::Disable:
    case DeviceRequest::Clear:
        m_state = ControllerState::Disabled;
        break;
    case DeviceRequest::Enable:
        m_state = ControllerState::Enabled;
        break;
    case DeviceRequest::Stop:
        m_state = ControllerState::Stopped;
        break;
    default:
        break;
    }
    if (setPoints.lengths && m_state == ControllerState::Enabled) {
        m_lengths = *setPoints.lengths;
    }
}

const DeviceFeedback& InstantDevice::read() {
    m_interruption.wait(kPeriod); // the wire's pace
    DeviceFeedback& feedback = m_feedback;
    feedback.notices.clear();
    feedback.lengths = m_lengths;
    feedback.receivedAt = std::chrono::steady_clock::now();
    feedback.controllerTime = ++m_cycle * std::chrono::duration_cast<std::chrono::microseconds>(kPeriod);
    feedback.link = LinkState::Connected;
    feedback.state = m_state;
    feedback.protectedLink = true;
    feedback.period = kPeriod;
    if (!m_named) {
        feedback.notices.push_back(notice::Identified{"instant"});
        m_named = true;
    }
    return feedback;
}

} // namespace hexapose::testing
