// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/control/control_loop_impl.h"
#include "core/kinematics/inverse_kinematics.h"

#include <algorithm>

namespace hexapose {

void ControlLoop::Impl::takeCommands(Clock::time_point time) {
    std::vector<OperatorCommand> taken;
    {
        const std::lock_guard lock(commandMutex);
        taken.swap(commands);
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
    const RunState present = state();
    const bool canStart = present == RunState::Enabled || present == RunState::Settling ||
                          present == RunState::Disabled || present == RunState::Unreferenced;
    const bool preparing = move && !moving();
    if (!takesCommands() || !canStart || preparing)
        return refuse("run");
    if (monitor.stale() || !measuredPose) {
        const std::string why = monitor.stale() ? "stale data" : std::string(toWord(solution.status));
        return raise({EventCode::MoveRefused, 0.0, why});
    }
    const Verdict verdict = checkLegPath(geometry, limits(), *measuredPose, command.target);
    if (!verdict.ok())
        return raise({EventCode::MoveRefused, 0.0, toWords(verdict)});
    const JointMove::Timing timing{options.settleTime, options.settleTimeout, options.enableTimeout,
                                   options.referenceTimeout};
    move.emplace(command.target, legLengths(geometry, command.target), feedback.state, timing, time);
    askToReference();
    enableTries = kTriesAgain;
    goal = command.target;
    tookOver = true;
    if (move->phase() == JointMove::Phase::Referencing)
        raise({EventCode::Referencing, 0.0, {}});
}

void ControlLoop::Impl::on(const StopCommand&, Clock::time_point) {
    if (feedback.link == LinkState::Lost || feedback.link == LinkState::ListenOnly)
        return refuse("stop");
    stop({EventCode::StopRequested, 0.0, {}});
}

void ControlLoop::Impl::on(const ReferenceCommand&, Clock::time_point) {
    if (!takesCommands() || move || (state() != RunState::Unreferenced && state() != RunState::Disabled))
        return refuse("reference");
    tookOver = true;
    askToReference();
    request(DeviceRequest::Reference);
    raise({EventCode::Referencing, 0.0, {}});
}

void ControlLoop::Impl::on(const EnableCommand&, Clock::time_point) {
    // Drives that were on when the link came up are taken over by being asked to go on.
    const bool canEnable = state() == RunState::Disabled || (state() == RunState::Enabled && !tookOver);
    if (!takesCommands() || move || !canEnable)
        return refuse("enable");
    tookOver = true;
    request(DeviceRequest::Enable);
}

void ControlLoop::Impl::on(const DisableCommand&, Clock::time_point) {
    if (!takesCommands())
        return refuse("disable");
    if (moving())
        return stop({EventCode::StopRequested, 0.0, "disable"});
    dropMotion();
    tookOver = false;
    referenceTries = 0;
    request(DeviceRequest::Disable);
}

void ControlLoop::Impl::on(const ClearCommand&, Clock::time_point) {
    if (!takesCommands() || (state() != RunState::Stopped && state() != RunState::Fault))
        return refuse("clear");
    dropMotion();
    clearSent = true;
    request(DeviceRequest::Clear);
}

} // namespace hexapose
