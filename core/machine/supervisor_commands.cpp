// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/supervisor.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

void Supervisor::processCommands(const std::vector<OperatorCommand>& commands) {
    // Stop beats everything queued with it, before and after.
    const auto isStop = [](const OperatorCommand& c) { return std::holds_alternative<StopCommand>(c); };
    if (std::any_of(commands.begin(), commands.end(), isStop))
        return on(StopCommand{});
    for (const OperatorCommand& command : commands)
        std::visit([&](const auto& c) { on(c); }, command);
}

void Supervisor::refuse(Command command, MotionId id) {
    raise({EventCode::CommandRefused, CommandRefusal{command, state(), allowed(), id}});
}

/// A command that is one row of the table. Refused, it changes nothing.
void Supervisor::obey(Command command) {
    if (!mayCommand(command))
        return refuse(command);
    apply(eventOf(command));
}

void Supervisor::order(MotionRunner::Order order) {
    if (!mayCommand(Command::Run))
        return refuse(Command::Run, order.id);
    if (const auto inhibit = motionInhibit())
        return raise({EventCode::MoveRefused, *inhibit});
    m_order = std::move(order);
    apply(MachineEvent::Run);
    followPlan();
}

void Supervisor::on(const RunCommand& command) {
    order({StraightMove{command.target, command.mode}, command.id, command.plan});
}

void Supervisor::on(const SweepCommand& command) {
    if (const auto fault = faultOf(command.settings))
        return raise({EventCode::MoveRefused, *fault});
    order({command.settings, command.id, {}});
}

/// Begins a jog, or keeps it going.
void Supervisor::on(const JogCommand& command) {
    const bool valid =
        command.direction.axis >= 0 && command.direction.axis < 6 && std::isfinite(command.speedOverride);
    if (!valid) {
        MotionCheck check;
        check.reason = MotionCheck::Reason::NotFinite;
        return raise({EventCode::MoveRefused, check});
    }
    if (m_motion.isEndedJog(command.id))
        return; // its button is still down, or the repeat comes late
    if (m_machine.run == RunState::Moving && m_motion.isJog(command.id))
        return m_motion.holdJog(command, m_time);
    if (!mayCommand(Command::Jog))
        return refuse(Command::Jog, command.id);
    if (const auto inhibit = motionInhibit())
        return raise({EventCode::MoveRefused, *inhibit});
    m_jogCommand = command;
    apply(MachineEvent::Jog);
    raise({EventCode::JogStarted});
}

void Supervisor::on(const JogReleaseCommand&) {
    m_motion.releaseJog();
}

void Supervisor::on(const SpeedCommand& command) {
    if (std::isfinite(command.speedOverride))
        m_motion.setSpeed(std::clamp(command.speedOverride, 0.0, 1.0));
}

void Supervisor::on(const HoldCommand&) {
    obey(Command::Hold);
}

void Supervisor::on(const ResumeCommand&) {
    obey(Command::Resume);
}

void Supervisor::on(const StopCommand&) {
    if (!mayCommand(Command::Stop))
        return refuse(Command::Stop);
    raise({EventCode::StopRequested});
    m_unresolvedStop.reset();
    apply(MachineEvent::Stop);
}

void Supervisor::on(const ReferenceCommand&) {
    if (!mayCommand(Command::Reference))
        return refuse(Command::Reference);
    apply(MachineEvent::Reference);
    raise({EventCode::Referencing});
}

void Supervisor::on(const EnableCommand&) {
    obey(Command::Enable);
}

void Supervisor::on(const DisableCommand&) {
    if (!mayCommand(Command::Disable))
        return refuse(Command::Disable);
    if (isInMotion(m_machine.run))
        raise({EventCode::StopRequested, Command::Disable});
    apply(MachineEvent::Disable);
}

void Supervisor::on(const ClearCommand&) {
    obey(Command::Clear);
}

} // namespace hexapose
