// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/control_loop_impl.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

void ControlLoop::Impl::takeCommands(Clock::time_point time) {
    std::vector<OperatorCommand> taken;
    {
        const std::lock_guard lock(commandMutex);
        taken.swap(commands);
        stopWaits = false;
    }
    // Stop beats everything queued with it, before and after.
    const auto isStop = [](const OperatorCommand& c) { return std::holds_alternative<StopCommand>(c); };
    if (std::any_of(taken.begin(), taken.end(), isStop)) {
        on(StopCommand{}, time);
        return;
    }
    for (const OperatorCommand& command : taken)
        std::visit([&](const auto& c) { on(c, time); }, command);
}

void ControlLoop::Impl::on(const RunCommand& command, Clock::time_point time) {
    prepareMotion(command, MachineEvent::Run, time);
}

void ControlLoop::Impl::on(const SweepCommand& command, Clock::time_point time) {
    if (const auto what = faultOf(command.settings))
        return raise({EventCode::MoveRefused, 0.0, *what});
    prepareMotion(command, MachineEvent::Run, time);
}

/// Starts a jog, or keeps it going.
void ControlLoop::Impl::on(const JogCommand& command, Clock::time_point time) {
    const bool valid =
        command.direction.axis >= 0 && command.direction.axis < 6 && std::isfinite(command.part);
    if (!valid)
        return raise({EventCode::MoveRefused, 0.0, "invalid-input"});
    if (jog && machine.run == RunState::Moving) {
        jogHeldAt = time;
        return jog->hold(command.direction, command.part);
    }
    if (!takesCommands() || !tookOver || !accepts(MachineEvent::Jog))
        return refuse(MachineEvent::Jog);
    if (const auto why = unfitToMove())
        return raise({EventCode::MoveRefused, 0.0, *why});
    apply(MachineEvent::Jog);
    auto begun = std::make_unique<JogMotion>(workspace, geometry, options.bounds,
                                             commanded.value_or(holdPoint()), *measuredPose);
    begun->hold(command.direction, command.part);
    jog = begun.get();
    law = std::move(begun);
    mode = MotionMode::Workspace;
    jogHeldAt = lastStep = time;
    goal.reset();
    move.emplace(ControllerState::Enabled, timing(), time);
    move->begin(time);
    raise({EventCode::JogStarted, 0.0, {}});
}

void ControlLoop::Impl::on(const JogReleaseCommand&, Clock::time_point) {
    if (jog)
        jog->release();
}

void ControlLoop::Impl::on(const SpeedCommand& command, Clock::time_point) {
    if (std::isfinite(command.part))
        speed = std::clamp(command.part, 0.0, 1.0);
}

void ControlLoop::Impl::on(const StopCommand&, Clock::time_point) {
    if (feedback.link == LinkState::Lost || feedback.link == LinkState::ListenOnly)
        return refuse(MachineEvent::Stop);
    stop({EventCode::StopRequested, 0.0, {}});
}

void ControlLoop::Impl::on(const ReferenceCommand&, Clock::time_point) {
    if (!takesCommands() || move || !accepts(MachineEvent::Reference))
        return refuse(MachineEvent::Reference);
    apply(MachineEvent::Reference);
    tookOver = true;
    askToReference();
    request(DeviceRequest::Reference);
    raise({EventCode::Referencing, 0.0, {}});
}

void ControlLoop::Impl::on(const EnableCommand&, Clock::time_point) {
    // Drives that were on when the link came up are taken over by being asked to go on.
    const bool takesOver = machine.run == RunState::Enabled && !tookOver;
    if (!takesCommands() || move || !(takesOver || accepts(MachineEvent::Enable)))
        return refuse(MachineEvent::Enable);
    tookOver = true;
    request(DeviceRequest::Enable);
}

void ControlLoop::Impl::on(const DisableCommand&, Clock::time_point) {
    if (!takesCommands())
        return refuse(MachineEvent::Disable);
    if (moving())
        return stop({EventCode::StopRequested, 0.0, "disable"});
    if (!apply(MachineEvent::Disable).defined)
        return;
    dropMotion();
    tookOver = false;
    referenceTries = 0;
    request(DeviceRequest::Disable);
}

void ControlLoop::Impl::on(const ClearCommand&, Clock::time_point) {
    if (!takesCommands() || !accepts(MachineEvent::Clear))
        return refuse(MachineEvent::Clear);
    dropMotion();
    apply(MachineEvent::Clear);
    request(DeviceRequest::Clear);
}

} // namespace hexapose
