// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/control_loop.h"

#include "core/machine/controller_link.h"
#include "core/machine/motion_runner.h"
#include "core/machine/pose_estimate.h"
#include "core/machine/supervisor.h"

#include <mutex>
#include <utility>
#include <vector>

namespace hexapose {

namespace {

constexpr std::chrono::milliseconds kShutDownWithin{1500}; ///< a disabling is repeated for so long

std::unique_ptr<Planner> orThread(std::unique_ptr<Planner> planner, const SharedModel& model) {
    return planner ? std::move(planner) : std::make_unique<PlanningThread>(model);
}

} // namespace

struct ControlLoop::Impl {
    Impl(PlatformDevice& device, SharedModel theModel, const ForwardSolver& solver,
         const ControlOptions& theOptions, Sink theSink, std::function<Clock::time_point()> theNow,
         std::unique_ptr<Planner> thePlanner)
        : model(std::move(theModel)), options(withDefaults(theOptions, model->geometry())),
          sink(std::move(theSink)), now(std::move(theNow)), sessionStart(now()),
          planner(orThread(std::move(thePlanner), model)), link(device, options.staleAfter),
          estimate(model, solver), motion(model, options, *planner),
          supervisor(model, options, link, estimate, motion) {}

    void begins(CyclePhase phase) {
        if (observer != nullptr)
            observer->onPhase(phase);
    }
    std::vector<OperatorCommand> takeCommands() {
        const std::lock_guard lock(commandMutex);
        return std::exchange(commands, {});
    }
    void updateTargetPose();
    Snapshot snapshot();
    void publish() { sink(snapshot()); }
    void exchange(DeviceRequest request);
    bool isConfirmedOff() const;

    const SharedModel model;
    const ControlOptions options;
    Sink sink;
    std::function<Clock::time_point()> now;
    const Clock::time_point sessionStart;
    std::unique_ptr<Planner> planner;

    ControllerLink link;
    PoseEstimate estimate;
    MotionRunner motion;
    Supervisor supervisor;

    std::mutex commandMutex;
    std::vector<OperatorCommand> commands;
    std::optional<LegLengths> solvedSetPoint; ///< the one that targetPose belongs to
    std::optional<Pose> targetPose;
    std::uint64_t cycleCount = 0;
    CycleObserver* observer = nullptr;
};

/// Where the platform should be now: on the path, or in joint mode the pose of the set-point.
void ControlLoop::Impl::updateTargetPose() {
    const std::optional<LegLengths>& setPoint = motion.setPoint();
    if (const std::optional<PoseReference> reference = setPoint ? motion.reference() : std::nullopt) {
        targetPose = reference->pose;
        solvedSetPoint.reset();
    } else if (!setPoint) {
        targetPose.reset();
        solvedSetPoint.reset();
    } else if (!solvedSetPoint || *solvedSetPoint != *setPoint) {
        targetPose = estimate.poseOf(*setPoint, targetPose);
        solvedSetPoint = setPoint;
    }
}

Snapshot ControlLoop::Impl::snapshot() {
    const DeviceFeedback& feedback = link.feedback();
    Snapshot s;
    s.time = now() - sessionStart;
    s.wallTime = std::chrono::system_clock::now();
    s.cycle = cycleCount++;
    s.state = supervisor.state();
    s.allowed = supervisor.allowed();
    s.link = feedback.link;
    s.controllerState = feedback.state;
    s.protectedLink = feedback.protectedLink;
    s.fresh = feedback.lengths.has_value();
    s.stale = link.monitor().stale();
    s.age = link.monitor().age();
    if (s.fresh) {
        s.controllerTime = feedback.controllerTime;
        s.roundTrip = feedback.roundTrip;
        s.jitter = link.monitor().jitter();
    }
    s.measuredLengths = estimate.lengths();
    s.commandedLengths = motion.setPoint();
    s.targetPose = targetPose;
    s.goalPose = motion.goal();
    s.measuredPose = estimate.pose();
    s.status = estimate.solution().status;
    s.iterations = estimate.solution().iterations;
    s.residual = estimate.solution().residual;
    s.solveTime = estimate.solveTime();
    s.mode = motion.mode();
    s.motionId = motion.id();
    s.held = supervisor.machine().held;
    s.speed = motion.speed();
    if (estimate.pose()) {
        s.smallestSingularValue = estimate.singularity().smallestSingularValue;
        s.determinantRatio = estimate.determinantRatio();
    }
    s.feedbackRate = link.monitor().rateHz();
    s.period = feedback.period;
    s.minLength = feedback.minLength;
    s.maxLength = feedback.maxLength;
    s.counters = feedback.counters;
    s.events = supervisor.takeEvents();
    return s;
}

ControlLoop::ControlLoop(PlatformDevice& device, SharedModel model, const ForwardSolver& solver,
                         const ControlOptions& options, Sink sink, std::function<Clock::time_point()> now,
                         std::unique_ptr<Planner> planner)
    : m_impl(std::make_unique<Impl>(device, std::move(model), solver, options, std::move(sink),
                                    std::move(now), std::move(planner))) {}

ControlLoop::~ControlLoop() = default;

void ControlLoop::setObserver(CycleObserver* observer) {
    m_impl->observer = observer;
}

void ControlLoop::post(const OperatorCommand& command) {
    {
        const std::lock_guard lock(m_impl->commandMutex);
        m_impl->commands.push_back(command);
    }
    if (std::holds_alternative<StopCommand>(command))
        m_impl->link.interrupt();
}

void ControlLoop::cycle() {
    Impl& loop = *m_impl;
    loop.begins(CyclePhase::Read);
    loop.link.read(loop.now);
    loop.begins(CyclePhase::Estimate);
    if (loop.link.feedback().lengths)
        loop.estimate.update(*loop.link.feedback().lengths);
    loop.begins(CyclePhase::Supervise);
    loop.supervisor.beginCycle(loop.now());
    loop.supervisor.processFeedback();
    loop.supervisor.watch();
    loop.supervisor.processCommands(loop.takeCommands());
    loop.supervisor.advance();
    loop.begins(CyclePhase::Generate);
    const SetPoints out = loop.supervisor.output();
    loop.begins(CyclePhase::Write);
    loop.link.write(out);
    loop.begins(CyclePhase::Publish);
    loop.updateTargetPose();
    loop.publish();
    loop.begins(CyclePhase::End);
}

void ControlLoop::Impl::exchange(DeviceRequest request) {
    link.write({std::nullopt, request});
    link.read(now);
    link.takeStateReport();
}

bool ControlLoop::Impl::isConfirmedOff() const {
    const ControllerState state = link.state();
    return link.acceptsCommands() && state != ControllerState::Unknown && state != ControllerState::Enabled;
}

void ControlLoop::shutDown() {
    Impl& loop = *m_impl;
    const LinkState open = loop.link.feedback().link;
    const bool reachable = open == LinkState::Connected || open == LinkState::Connecting;
    const bool stopping = loop.supervisor.isStoppingDue();
    const bool enabled = loop.supervisor.mayBeEnabled();
    loop.supervisor.endMotion();
    loop.updateTargetPose();
    if (!reachable || (!stopping && !enabled))
        return;
    loop.exchange(DeviceRequest::Stop);
    loop.exchange(DeviceRequest::Disable);
    const Clock::time_point begin = loop.now();
    const auto timeLeft = [&] { return loop.now() - begin < kShutDownWithin; };
    while (!loop.isConfirmedOff() && timeLeft())
        loop.exchange(DeviceRequest::None);
    if (!loop.isConfirmedOff()) {
        loop.supervisor.raise({EventCode::DisableUnconfirmed});
        Snapshot last = loop.snapshot();
        last.fresh = false;
        loop.sink(last);
    }
}

} // namespace hexapose
