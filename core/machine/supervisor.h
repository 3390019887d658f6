// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/machine/command.h"
#include "core/machine/control_options.h"
#include "core/machine/controller_link.h"
#include "core/machine/following_error_monitor.h"
#include "core/machine/machine_state.h"
#include "core/machine/motion_runner.h"
#include "core/machine/pose_estimate.h"
#include "core/machine/request_queue.h"
#include "core/record/event.h"
#include "core/record/snapshot.h"

#include <optional>
#include <vector>

namespace hexapose {

/// Decides, in each cycle, what the machine does: applies what happened to the machine table and carries out
/// the table's action. Split over supervisor.cpp (the table, the watch, what goes out),
/// supervisor_commands.cpp (the operator's side) and supervisor_feedback.cpp (the controller's side).
class Supervisor {
public:
    using Clock = std::chrono::steady_clock;

    /// options: complete. All others outlive the supervisor.
    Supervisor(SharedModel model, const ControlOptions& options, ControllerLink& link, PoseEstimate& estimate,
               MotionRunner& motion);

    // A cycle, in this order.
    void beginCycle(Clock::time_point time);
    void processFeedback();
    void processCommands(const std::vector<OperatorCommand>& commands);
    void watch();
    void advance();
    /// The set-point and the request of this cycle. Every set-point passes the last gate here.
    SetPoints output();

    const MachineState& machine() const { return m_machine; }
    RunState state() const; ///< as the screen and the log have it
    CommandSet allowed() const;
    std::vector<Event> takeEvents() { return std::exchange(m_events, {}); }
    void raise(Event event) { m_events.push_back(std::move(event)); }

    // At the end of the session.
    bool mayBeEnabled() const; ///< by us, as far as we know
    bool isStoppingDue() const { return m_motion.active() || m_requests.stopDue(); }
    void endMotion();

private:
    // What the table prescribes for an event; the state follows and its action is carried out.
    bool apply(MachineEvent event);
    void execute(MachineAction action);
    bool mayCommand(Command command) const;
    void refuse(Command command, MotionId id = kNoMotion);
    /// Ends whatever moves, and stops and disables the controller; it stays stopped until Clear.
    void stop(Event cause);
    void stopSilently();

    void on(const RunCommand& command);
    void on(const SweepCommand& command);
    void on(const JogCommand& command);
    void on(const JogReleaseCommand& command);
    void on(const SpeedCommand& command);
    void on(const HoldCommand& command);
    void on(const ResumeCommand& command);
    void on(const StopCommand& command);
    void on(const ReferenceCommand& command);
    void on(const EnableCommand& command);
    void on(const DisableCommand& command);
    void on(const ClearCommand& command);
    void obey(Command command);
    void order(MotionRunner::Order order);
    void followPlan();
    void tryToBegin();

    void on(const notice::Identified& notice);
    void on(const notice::Refused& notice);
    void on(const notice::Fault& notice);
    void on(const notice::Acknowledged& notice);
    void on(const notice::NoAnswer& notice);
    void on(const notice::ClockWentBack& notice);
    void on(const notice::ListenOnly& notice);
    void on(const notice::LinkLost& notice);
    void onSetPointRefused(const DeviceRefusal& refusal);
    void followController();
    void reportStateChange(const ControllerLink::StateReport& report, const MachineState& was,
                           bool wasActive);
    void resolveStopCause();
    void checkIdentity();

    std::optional<MotionInhibit> motionInhibit() const;
    std::optional<Event> nearLimit() const;
    const MotionLimits& limits() const { return m_planner.limits(); }
    MotionRunner::Cycle cycle() const;

    SharedModel m_model;
    const ControlOptions m_options;
    MotionPlanner m_planner; ///< for the limits in force
    ControllerLink& m_link;
    PoseEstimate& m_estimate;
    MotionRunner& m_motion;

    MachineState m_machine;
    RequestQueue m_requests;
    FollowingErrorMonitor m_following;
    Clock::time_point m_time{};
    std::vector<Event> m_events;
    std::optional<MotionRunner::Order> m_order; ///< for the action Plan
    std::optional<JogCommand> m_jogCommand;     ///< for the action BeginJog

    bool m_enabledByUs = false;  ///< reference or enable was sent, and no disabling has been confirmed since
    bool m_disableAsked = false; ///< and its state has not come yet
    bool m_wasStale = true;
    std::optional<DeviceRefusal>
        m_unresolvedStop; ///< it stopped the motion and waits for the state that explains it
    Clock::time_point m_unresolvedSince{};
    std::optional<DeviceRefusal> m_lastSetRefusal;
    Clock::time_point m_lastSetRefusalAt{};
};

} // namespace hexapose
