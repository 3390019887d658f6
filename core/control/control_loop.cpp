// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/control/control_loop.h"

#include "core/control/control_loop_impl.h"
#include "core/geometry/number_text.h"
#include "core/geometry/units.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kStrokeSeconds = 2.5;   ///< default leg speed: mean stroke in so long
constexpr double kFastestLeg = 0.08;     ///< m/s, below what the drives can do
constexpr double kSettleWindow = 2e-4;   ///< m
constexpr double kSettleOfStroke = 2e-3; ///< for machines with tiny strokes
/// Largest distance of a leg from its set-point, of the machine's size: 24 mm for the laboratory platform,
/// whose legs lag by 10 mm at most.
constexpr double kFollowingOfSize = 0.08;
constexpr double kOrdinaryLag = 0.3; ///< s; a machine of long strokes for its size may lag further
constexpr std::chrono::milliseconds kShutDownWithin{1500}; ///< a disabling is repeated for so long

ControlOptions completed(ControlOptions options, const PlatformGeometry& geometry) {
    double stroke = 0.0;
    for (const Leg& leg : geometry.legs)
        stroke += (leg.maxLength - leg.minLength) / kLegCount;
    if (options.legSpeed <= 0.0)
        options.legSpeed = std::min(stroke / kStrokeSeconds, kFastestLeg);
    if (options.settleWindow <= 0.0)
        options.settleWindow = std::min(kSettleWindow, kSettleOfStroke * stroke);
    if (options.followingLimit <= 0.0)
        options.followingLimit =
            std::max(kFollowingOfSize * geometry.size(), kOrdinaryLag * options.legSpeed);
    return options;
}

RunState fromController(ControllerState state) {
    switch (state) {
    case ControllerState::Unknown:
        return RunState::Disconnected;
    case ControllerState::Unreferenced:
        return RunState::Unreferenced;
    case ControllerState::Disabled:
        return RunState::Disabled;
    case ControllerState::Enabled:
        return RunState::Enabled;
    case ControllerState::Stopped:
        return RunState::Stopped;
    case ControllerState::Fault:
        return RunState::Fault;
    }
    return RunState::Disconnected;
}

} // namespace

ControlLoop::Impl::Impl(PlatformDevice& theDevice, const PlatformGeometry& theGeometry,
                        const ForwardSolver& theSolver, const ControlOptions& theOptions, Sink theSink,
                        Now theNow)
    : device(theDevice), geometry(theGeometry), solver(theSolver),
      options(completed(theOptions, theGeometry)), sink(std::move(theSink)), now(std::move(theNow)),
      sessionStart(now()), monitor(options.staleAfter), follow(options.followingLimit, options.echoWithin) {}

RunState ControlLoop::Impl::state() const {
    if (feedback.link == LinkState::ListenOnly)
        return RunState::Disabled; // an unprotected sender takes no commands
    if (feedback.link != LinkState::Connected)
        return RunState::Disconnected;
    if (feedback.state == ControllerState::Fault)
        return RunState::Fault;
    if (stopLatched)
        return RunState::Stopped;
    if (feedback.state == ControllerState::Enabled && move) {
        if (move->phase() == JointMove::Phase::Moving)
            return RunState::Moving;
        if (move->phase() == JointMove::Phase::Settling)
            return RunState::Settling;
    }
    return fromController(feedback.state);
}

void ControlLoop::Impl::dropMotion() {
    move.reset();
    commanded.reset();
    commandedPose.reset();
    follow.reset();
    goal.reset(); // after a stop the target is where the platform is
}

void ControlLoop::Impl::stop(Event cause) {
    raise(std::move(cause));
    halt();
}

void ControlLoop::Impl::halt() {
    unnamedStop.clear();
    dropMotion();
    stopLatched = takesCommands();
    clearSent = tookOver = false;
    referenceTries = 0;
    pendingRequest = DeviceRequest::Stop;
}

/// Where the legs are. A measurement a hair beyond the end of a stroke, by no more than the settle window, is
/// that end: its noise must not stop a machine that stands there.
LegLengths ControlLoop::Impl::holdPoint() const {
    const MotionLimits bounds = limits();
    LegLengths hold = *measured;
    for (int i = 0; i < kLegCount; ++i) {
        const double within = std::min(std::max(hold[i], bounds.minLength[i]), bounds.maxLength[i]);
        if (std::abs(within - hold[i]) <= options.settleWindow)
            hold[i] = within;
    }
    return hold;
}

/// Another name or other limits than before: what was judged and sent so far was meant for another machine.
void ControlLoop::Impl::watchIdentity() {
    if (!takesCommands())
        return;
    Identity present{feedback.controllerName, feedback.minLength, feedback.maxLength};
    if (identity && *identity != present && (move || commanded)) {
        std::string detail = present.name;
        if (present.minLength && present.maxLength)
            detail += ", " + formatNumber(mmFromMetres(*present.minLength)) + " to " +
                      formatNumber(mmFromMetres(*present.maxLength)) + " mm";
        stop({EventCode::StoppedOnNewIdentity, 0.0, detail});
    }
    identity = std::move(present);
}

SetPoints ControlLoop::Impl::nextSetPoints(Clock::time_point time) {
    SetPoints out;
    if (!commanded)
        follow.reset();
    if (pendingRequest == DeviceRequest::None && move)
        request(move->takeRequest());
    out.request = std::exchange(pendingRequest, DeviceRequest::None);
    if (out.request == DeviceRequest::Stop || stopLatched || !tookOver || !takesCommands() ||
        feedback.state != ControllerState::Enabled)
        return out;
    if (moving()) {
        move->step(time, options.longestPathStep);
        commanded = move->setPoint();
    } else if (!commanded && !monitor.stale()) {
        commanded = holdPoint(); // the controller's watchdog wants to hear us
    }
    if (!commanded)
        return out;
    if (const Verdict verdict = checkLegs(limits(), *commanded); !verdict.ok()) {
        stop({EventCode::StoppedOnLimits, 0.0, toWords(verdict)});
        return {std::nullopt, std::exchange(pendingRequest, DeviceRequest::None)};
    }
    out.lengths = commanded;
    follow.sent(time);
    return out;
}

void ControlLoop::Impl::advanceMove(Clock::time_point time) {
    if (!move)
        return;
    if (std::optional<Event> event =
            move->update(feedback.state, feedback.lengths, options.settleWindow, time))
        raise(std::move(*event));
    if (move->phase() == JointMove::Phase::Failed)
        return dropMotion();
    if (move->phase() == JointMove::Phase::Settled)
        return move.reset(); // the set-point is held from here on
    if (move->phase() != JointMove::Phase::Ready || feedback.state != ControllerState::Enabled ||
        !measuredPose)
        return;
    // Referencing may have moved the legs: judge the path again from where the platform is now.
    const Verdict verdict = checkLegPath(geometry, limits(), *measuredPose, move->target());
    if (!verdict.ok()) {
        raise({EventCode::MoveRefused, 0.0, toWords(verdict)});
        return dropMotion();
    }
    move->start(commanded.value_or(holdPoint()), options.legSpeed, time);
    raise({EventCode::MoveStarted, std::chrono::duration<double>(move->duration()).count(), {}});
}

void ControlLoop::Impl::publish(Clock::time_point time) {
    if (commanded) {
        const ForwardResult path = solver.solve(*commanded, commandedPose.value_or(lastPose));
        commandedPose = path.isUsable() ? std::optional(path.pose) : std::nullopt;
    }
    Snapshot s;
    s.time = time - sessionStart;
    s.wallTime = std::chrono::system_clock::now();
    s.cycle = cycleCount++;
    s.state = state();
    s.link = feedback.link;
    s.controllerState = feedback.state;
    s.protectedLink = feedback.protectedLink;
    s.fresh = feedback.lengths.has_value();
    s.stale = monitor.stale();
    s.age = monitor.age();
    s.measuredLengths = measured;
    s.commandedLengths = commanded;
    s.targetPose = commandedPose;
    s.goalPose = goal;
    s.measuredPose = measuredPose;
    s.status = solution.status;
    s.iterations = solution.iterations;
    s.residual = solution.residual;
    s.solveTime = solveTime;
    s.feedbackRate = monitor.rateHz();
    s.period = feedback.period;
    s.minLength = feedback.minLength;
    s.maxLength = feedback.maxLength;
    s.counters = feedback.counters;
    s.events = std::exchange(events, {});
    sink(s);
}

ControlLoop::ControlLoop(PlatformDevice& device, const PlatformGeometry& geometry,
                         const ForwardSolver& solver, const ControlOptions& options, Sink sink,
                         std::function<Clock::time_point()> now)
    : m_impl(std::make_unique<Impl>(device, geometry, solver, options, std::move(sink), std::move(now))) {}

ControlLoop::~ControlLoop() = default;

void ControlLoop::post(const OperatorCommand& command) {
    const std::lock_guard lock(m_impl->commandMutex);
    m_impl->commands.push_back(command);
}

void ControlLoop::cycle() {
    Impl& loop = *m_impl;
    const Clock::time_point begin = loop.now();
    loop.takeCommands(begin);
    loop.feedback = loop.device.exchange(loop.nextSetPoints(begin));
    const Clock::time_point time = loop.now();
    loop.takeFeedback(time);
    loop.nameStop(time);
    loop.noteStateChange();
    loop.watchIdentity();
    loop.watch(time);
    loop.advanceMove(time);
    loop.publish(time);
}

void ControlLoop::shutDown() {
    Impl& loop = *m_impl;
    if (!loop.takesCommands())
        return;
    // A stop that the last cycle decided on has not gone out yet.
    const bool stopFirst = loop.move.has_value() || loop.pendingRequest == DeviceRequest::Stop;
    const bool disable = loop.feedback.state == ControllerState::Enabled;
    loop.dropMotion();
    if (stopFirst)
        loop.feedback = loop.device.exchange({std::nullopt, DeviceRequest::Stop});
    if (disable)
        loop.feedback = loop.device.exchange({std::nullopt, DeviceRequest::Disable});
    const auto on = [&loop] {
        return loop.takesCommands() && loop.feedback.state == ControllerState::Enabled;
    };
    const Clock::time_point begin = loop.now();
    while (on() && loop.now() - begin < kShutDownWithin)
        loop.feedback = loop.device.exchange({});
    if (!on())
        return;
    loop.feedback.lengths.reset();
    loop.raise({EventCode::DisableUnconfirmed, 0.0, {}});
    loop.publish(loop.now());
}

} // namespace hexapose
