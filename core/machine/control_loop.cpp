// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/control_loop.h"

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/machine/control_loop_impl.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kSettleWindow = 2e-4;       ///< m
constexpr double kSettleOfStroke = 2e-3;     ///< for machines with small strokes,
constexpr double kSettleRounding = 1e-4;     ///< m, but no less than a length is commonly rounded to,
constexpr double kSettleMostOfStroke = 0.02; ///< unless that is much of the stroke
/// Largest distance of a leg from its set-point, of the machine's size: 24 mm for the laboratory platform,
/// whose legs lag by 10 mm at most.
constexpr double kFollowingOfSize = 0.08;
constexpr double kOrdinaryLag = 0.3;    ///< s; a machine of long strokes for its size may lag further
constexpr double kGapOfFollowing = 0.5; ///< a set-point goes so far ahead of its leg, of what would stop
constexpr double kRestOfWindow = 0.5;   ///< an error so small is not corrected any more, of the settle window
constexpr std::chrono::milliseconds kShutDownWithin{1500}; ///< a disabling is repeated for so long

WorkspaceOptions workspaceOptions(const ControlOptions& options) {
    WorkspaceOptions workspace;
    workspace.gain = options.gain;
    workspace.legSpeed = options.bounds.legSpeed;
    workspace.gapLimit = kGapOfFollowing * options.followingLimit;
    workspace.restDistance = kRestOfWindow * options.settleWindow.distance;
    workspace.restAngle = kRestOfWindow * options.settleWindow.angle;
    return workspace;
}

} // namespace

ControlOptions withDefaults(ControlOptions options, const PlatformGeometry& geometry) {
    options.bounds = withDefaults(options.bounds, geometry);
    double stroke = 0.0;
    for (const Leg& leg : geometry.legs)
        stroke += (leg.maxLength - leg.minLength) / kLegCount;
    if (options.settleWindow.distance <= 0.0)
        options.settleWindow.distance =
            std::min(kSettleWindow, std::max(kSettleOfStroke * stroke,
                                             std::min(kSettleRounding, kSettleMostOfStroke * stroke)));
    if (options.settleWindow.angle <= 0.0)
        options.settleWindow.angle = options.settleWindow.distance / geometry.jointRadius();
    if (options.followingLimit <= 0.0)
        options.followingLimit =
            std::max(kFollowingOfSize * geometry.size(), kOrdinaryLag * options.bounds.legSpeed);
    return options;
}

ControlLoop::Impl::Impl(PlatformDevice& theDevice, const PlatformGeometry& theGeometry,
                        const ForwardSolver& theSolver, const ControlOptions& theOptions, Sink theSink,
                        Now theNow)
    : device(theDevice), geometry(theGeometry), solver(theSolver),
      options(withDefaults(theOptions, theGeometry)), sink(std::move(theSink)), now(std::move(theNow)),
      sessionStart(now()), monitor(options.staleAfter), follow(options.followingLimit, options.echoWithin),
      homeDeterminant(singularityMeasure(geometry, Pose{}).determinant),
      workspace(geometry, workspaceOptions(options)) {}

MotionLimits ControlLoop::Impl::limits() const {
    MotionLimits all = motionLimits(geometry, feedback.minLength, feedback.maxLength);
    all.envelope = options.envelope;
    all.legSpeed = options.bounds.legSpeed;
    all.legAcceleration = options.bounds.legAcceleration;
    return all;
}

Transition ControlLoop::Impl::apply(MachineEvent event) {
    const Transition made = transition(machine, event);
    machine = made.next;
    if (!made.defined && isCommand(event))
        refuse(event);
    return made;
}

void ControlLoop::Impl::dropMotion() {
    move.reset();
    wish.reset();
    law.reset();
    jog = nullptr;
    apply(MachineEvent::MotionDropped);
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
    apply(MachineEvent::Trips);
    dropMotion();
    tookOver = false;
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
        if (std::abs(within - hold[i]) <= options.settleWindow.distance)
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
    const std::chrono::nanoseconds since = std::clamp<std::chrono::nanoseconds>(
        time - std::exchange(lastStep, time), std::chrono::nanoseconds(0), options.longestPathStep);
    const bool on = machine.run == RunState::Enabled || moving();
    if (out.request == DeviceRequest::Stop || !on || !tookOver || !takesCommands() ||
        feedback.state != ControllerState::Enabled)
        return out;
    if (law) {
        if (jog && time - jogHeldAt > options.jogHold)
            jog->release();
        MotionGenerator::Cycle cycle{std::chrono::duration<double>(since).count(), speed, {}, {}, limits()};
        if (feedback.lengths && measuredPose) {
            cycle.lengths = feedback.lengths;
            cycle.pose = measuredPose;
        }
        commanded = law->step(cycle);
    } else if (!commanded && !monitor.stale()) {
        commanded = holdPoint(); // the controller's watchdog wants to hear us
    }
    if (!commanded)
        return out;
    if (const MotionCheck check = checkLegs(limits(), *commanded); !check.ok()) {
        stop({EventCode::StoppedOnLimits, 0.0, toWords(check)});
        return {std::nullopt, std::exchange(pendingRequest, DeviceRequest::None)};
    }
    out.lengths = commanded;
    follow.sent(time);
    return out;
}

void ControlLoop::Impl::publish(Clock::time_point time) {
    if (commanded) {
        const std::optional<PoseReference> reference = law ? law->reference() : std::nullopt;
        const ForwardResult path =
            reference ? ForwardResult{} : solver.solve(*commanded, commandedPose.value_or(lastPose));
        commandedPose = reference         ? std::optional(reference->pose)
                        : path.isUsable() ? std::optional(path.pose)
                                          : std::nullopt;
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
    s.mode = mode;
    s.speed = speed;
    if (measuredPose) {
        s.smallestSingularValue = singularity.smallestSingularValue;
        s.determinantRatio = singularity.determinant / homeDeterminant;
    }
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
    m_impl->stopWaits = m_impl->stopWaits || std::holds_alternative<StopCommand>(command);
}

void ControlLoop::cycle() {
    Impl& loop = *m_impl;
    const Clock::time_point begin = loop.now();
    loop.takeCommands(begin);
    SetPoints out = loop.nextSetPoints(begin);
    out.hurry = &loop.stopWaits;
    loop.feedback = loop.device.exchange(out);
    const Clock::time_point time = loop.now();
    loop.takeFeedback(time);
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
