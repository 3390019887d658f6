// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/kinematics/inverse_kinematics.h"
#include "core/machine/control_loop_impl.h"

#include <utility>

namespace hexapose {

namespace {

constexpr std::chrono::seconds kSameRefusalEvery{1};
constexpr std::chrono::milliseconds kStateComesWithin{300}; ///< some feedback periods

MachineEvent reportOf(ControllerState state) {
    switch (state) {
    case ControllerState::Unreferenced:
        return MachineEvent::IsUnreferenced;
    case ControllerState::Disabled:
        return MachineEvent::IsDisabled;
    case ControllerState::Enabled:
        return MachineEvent::IsEnabled;
    case ControllerState::Stopped:
        return MachineEvent::IsStopped;
    case ControllerState::Fault:
        return MachineEvent::HasFault;
    case ControllerState::Unknown:
        break;
    }
    return MachineEvent::LinkGone;
}

bool isDown(ControllerState state) {
    return state == ControllerState::Stopped || state == ControllerState::Fault;
}

} // namespace

void ControlLoop::Impl::takeFeedback(Clock::time_point time) {
    const ControllerState before = knownState;
    const RunState was = machine.run;
    followController();
    for (const DeviceNotice& notice : feedback.notices)
        takeNotice(notice, time);
    monitor.update(feedback, time);
    if (feedback.lengths) {
        measured = feedback.lengths;
        solve();
    }
    if (feedback.link == LinkState::Connected) {
        if (std::exchange(stopWhenBack, false))
            stop({EventCode::StoppedAfterLoss, 0.0, {}});
    } else {
        stopWhenBack = stopWhenBack || move.has_value();
        dropMotion();
        tookOver = false; // the controller says its state again when it is back, and nothing is asked
        if (feedback.link == LinkState::Lost)
            monitor.forget();
    }
    nameStop(time);
    noteStateChange(before, was);
}

/// The machine's state follows the controller's, as far as the table has it so.
void ControlLoop::Impl::followController() {
    const ControllerState after = takesCommands() ? feedback.state : ControllerState::Unknown;
    const ControllerState before = std::exchange(knownState, after);
    if (after == ControllerState::Unknown) {
        apply(MachineEvent::LinkGone);
        return;
    }
    if (!feedback.lengths && before == after)
        return; // nothing new, and a state from before a request says nothing of what came of it
    if (isDown(before) && !isDown(after))
        apply(MachineEvent::LeftStop);
    if (before == ControllerState::Unreferenced && after != before)
        referenceTaken = true; // whether or not its answer came through
    apply(reportOf(after));
}

/// Says what stopped the move, once the controller's state has come, or that it restarted, or nothing more.
void ControlLoop::Impl::nameStop(Clock::time_point time) {
    if (unnamedStop.empty())
        return;
    if (!takesCommands()) { // the restart, or the loss, was said
        unnamedStop.clear();
    } else if (feedback.state != ControllerState::Enabled) {
        raise({EventCode::StoppedByController, 0.0, std::string(1, static_cast<char>(feedback.state))});
        unnamedStop.clear();
    } else if (time - unnamedSince > kStateComesWithin) {
        raise({EventCode::StoppedOnRefusal, 0.0, unnamedStop});
        unnamedStop.clear();
    }
}

void ControlLoop::Impl::noteStateChange(ControllerState before, RunState was) {
    const ControllerState after = knownState;
    const bool wasDown = was == RunState::Stopped || was == RunState::Fault;
    const bool down = after == ControllerState::Disabled || after == ControllerState::Unreferenced;
    // A controller may answer a stop without a state for it; Clear ends that stop too.
    if (wasDown && (machine.run == RunState::Disabled || machine.run == RunState::Unreferenced))
        return raise({EventCode::Cleared, 0.0, {}});
    if (before == after || after == ControllerState::Unknown)
        return;
    const bool wentDown =
        isDown(after) || (before == ControllerState::Enabled && after != ControllerState::Enabled);
    if (wentDown) {
        if (was != RunState::Stopped && (move || before == ControllerState::Enabled))
            raise({EventCode::StoppedByController, 0.0, std::string(1, static_cast<char>(after))});
        dropMotion();
        tookOver = false;
    }
    if (!move && after == ControllerState::Enabled && !wasDown) {
        raise({EventCode::Enabled, 0.0, {}});
    } else if (!move && down && !wasDown && after == ControllerState::Disabled) {
        raise(
            {before == ControllerState::Unreferenced ? EventCode::Referenced : EventCode::Disabled, 0.0, {}});
    }
}

void ControlLoop::Impl::takeNotice(const DeviceNotice& notice, Clock::time_point time) {
    switch (notice.kind) {
    case DeviceNotice::Kind::Identified:
        return raise({EventCode::Connected, 0.0, notice.text});
    case DeviceNotice::Kind::Refused:
        return takeRefusal(notice, time);
    case DeviceNotice::Kind::Fault:
        return raise({EventCode::ControllerFault, 0.0, notice.request + " " + notice.text});
    case DeviceNotice::Kind::NoAnswer:
        return takeNoAnswer(notice);
    case DeviceNotice::Kind::Acknowledged:
        referenceTaken = referenceTaken || notice.request == "HOME";
        return;
    case DeviceNotice::Kind::ClockWentBack:
        if (move)
            stop({EventCode::ClockWentBack, 0.0, {}});
        else
            raise({EventCode::ClockWentBack, 0.0, {}});
        return;
    case DeviceNotice::Kind::ListenOnly:
        return raise({EventCode::ListenOnly, 0.0, {}});
    case DeviceNotice::Kind::LinkLost:
        return raise({EventCode::LinkLost, 0.0, notice.text});
    }
}

/// A frame may be lost: what prepares a motion is asked for again, and given up soon when nothing answers.
void ControlLoop::Impl::takeNoAnswer(const DeviceNotice& notice) {
    raise({EventCode::NoAnswer, 0.0, notice.request});
    const bool preparing = move && move->preparing();
    const bool home = notice.request == "HOME" && !referenceTaken;
    const bool enable = notice.request == "ENABLE" && preparing;
    if (!takesCommands() || (!home && !enable))
        return;
    int& tries = home ? referenceTries : enableTries;
    if (tries > 0) {
        --tries;
        return request(home ? DeviceRequest::Reference : DeviceRequest::Enable);
    }
    if (preparing) {
        dropMotion();
        raise({EventCode::PreparationFailed, 0.0, notice.request + " was not answered"});
    }
}

void ControlLoop::Impl::takeRefusal(const DeviceNotice& notice, Clock::time_point time) {
    const std::string what = notice.request + " " + notice.text;
    if (notice.request == "SET") {
        if (moving() && notice.text.starts_with("STATE")) {
            // The drives went down on their own; the measurement that says so comes a moment later.
            raise({EventCode::ControllerRefused, 0.0, what});
            halt();
            unnamedStop = what;
            unnamedSince = time;
            return;
        }
        if (moving())
            return stop({EventCode::StoppedOnRefusal, 0.0, what});
        // A held set-point is refused in every cycle: say it once a second.
        if (what == lastSetRefusalText && time - lastSetRefusal < kSameRefusalEvery)
            return;
        lastSetRefusal = time;
        lastSetRefusalText = what;
    } else if (notice.request == "HOME" &&
               (referenceTaken || (move && move->phase() != Move::Phase::Referencing))) {
        // Asked again before a late answer came: it refers to the asking again.
    } else if (move && (notice.request == "HOME" || notice.request == "ENABLE")) {
        dropMotion();
        return raise({EventCode::PreparationFailed, 0.0, what});
    }
    raise({EventCode::ControllerRefused, 0.0, what});
}

void ControlLoop::Impl::solve() {
    const Clock::time_point begin = Clock::now();
    solution = solver.solve(*measured, lastPose);
    solveTime = Clock::now() - begin;
    measuredPose.reset();
    if (solution.isUsable()) {
        measuredPose = solution.pose;
        lastPose = solution.pose;
        singularity = singularityMeasure(geometry, solution.pose);
    }
}

void ControlLoop::Impl::watch(Clock::time_point time) {
    const bool stale = monitor.stale();
    if (stale != wasStale) {
        if (stale)
            follow.reset();
        if (stale)
            raise(
                {EventCode::DataStale, std::chrono::duration<double, std::milli>(monitor.age()).count(), {}});
        else
            raise({EventCode::DataFresh, 0.0, {}});
        wasStale = stale;
    }
    // While something moves, or a pose is held by what is measured, every measurement must be good.
    const bool led = move || law;
    if (led && stale)
        return stop({EventCode::StoppedOnStaleData, 0.0, {}});
    if (led && feedback.lengths && !measuredPose)
        return stop({EventCode::StoppedOnSolver, 0.0, std::string(toWord(solution.status))});
    if (law && feedback.lengths)
        if (std::optional<Event> cause = nearLimit())
            return stop(std::move(*cause));
    if (law && feedback.lengths)
        if (const std::optional<PoseReference> reference = law->reference())
            if (std::optional<Event> cause =
                    follow.judgePath(legLengths(geometry, reference->pose), *feedback.lengths, law->stalls()))
                return stop(std::move(*cause));
    if (commanded && measuredPose)
        if (std::optional<Event> cause = follow.judge(feedback, *commanded, time))
            stop(std::move(*cause));
}

} // namespace hexapose
