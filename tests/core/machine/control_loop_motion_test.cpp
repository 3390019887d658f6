// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Jogs, limits and plans in the loop.
#include "core/kinematics/inverse_kinematics.h"
#include "core/record/device_words.h"
#include "tests/core/machine/control_loop_fixture.h"

namespace hexapose {
namespace {

using testing::kSettleWindow;
using testing::target;
class ControlLoopMotion : public testing::ControlLoopTest {};

TEST_F(ControlLoopMotion, OnePressIsOneJog) {
    enable();
    const auto hold = [this](MotionId press) {
        m_loop->post(JogCommand{{2, true, JogFrame::Base}, 1.0, press});
        cycles(1);
    };
    for (int i = 0; i < 20; ++i)
        hold(1);
    EXPECT_EQ(m_last.state, RunState::Moving);
    EXPECT_EQ(count(EventCode::JogStarted), 1);
    hold(2); // a second key, while the first is down
    EXPECT_TRUE(saw(EventCode::CommandRefused)) << "one motion at a time";
    m_loop->post(JogReleaseCommand{});
    until(RunState::Enabled);
    const std::size_t mark = m_device.received.size();
    const auto there = m_device.received.back().lengths;
    for (int i = 0; i < 20; ++i)
        hold(1); // the button is still down, or its repeats arrive late
    EXPECT_EQ(m_last.state, RunState::Enabled);
    EXPECT_EQ(count(EventCode::JogStarted), 1);
    EXPECT_LT((*m_device.received.back().lengths - *there).norm(), kSettleWindow);
    EXPECT_TRUE(requestsSince(mark).empty());
    hold(3);
    EXPECT_EQ(m_last.state, RunState::Moving);
}

TEST_F(ControlLoopMotion, AJogWithStaleDataIsRefused) {
    enable();
    m_device.silent = true;
    cycles(50);
    ASSERT_TRUE(m_last.stale);
    m_events.clear();
    m_loop->post(JogCommand{{2, true, JogFrame::Base}, 1.0, 1});
    cycles(1);
    EXPECT_EQ(detailOf(EventCode::MoveRefused), "stale data");
    EXPECT_NE(m_last.state, RunState::Moving);
}

TEST_F(ControlLoopMotion, TheEnvelopeHoldsForRunsAndJogs) {
    ControlOptions options;
    options.envelope.furthest.head<3>().setConstant(0.01);
    rebuild(options);
    enable();
    m_loop->post(RunCommand{Pose{{0.0, 0.0, 0.02}, {}}});
    cycles(2);
    EXPECT_EQ(detailOf(EventCode::MoveRefused), "z outside the envelope");
    for (int i = 0; i < 400 && !saw(EventCode::JogLimited); ++i) {
        m_loop->post(JogCommand{{2, true, JogFrame::Base}, 1.0, 1});
        cycles(1);
    }
    EXPECT_EQ(detailOf(EventCode::JogLimited), "z outside the envelope");
    EXPECT_LT(m_last.measuredPose->offset.z(), 0.01);
}

TEST_F(ControlLoopMotion, AMeasuredPoseNearASingularOneStopsTheMotion) {
    ControlOptions options;
    options.followingLimit = 10.0; // m: what stops is the pose alone
    rebuild(options);
    startMoving();
    Pose turned;
    // In steps so small that the solver follows all the way.
    for (int k = 0; k <= 400 && m_last.state != RunState::Stopped; ++k) {
        turned.angles.gamma = radiansFromDeg(0.3 * k);
        m_device.reportInstead = legLengths(m_geometry, turned);
        cycles(1);
    }
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_EQ(detailOf(EventCode::StoppedOnLimits), "near singular") << formatEvents(m_events);
    EXPECT_GT(turned.angles.gamma, radiansFromDeg(60));
    const auto limit = std::find_if(m_events.begin(), m_events.end(),
                                    [](const Event& e) { return e.code == EventCode::StoppedOnLimits; });
    ASSERT_NE(limit, m_events.end());
    EXPECT_LT(limit->get<MotionCheck>()->value, limit->get<MotionCheck>()->bound);
    EXPECT_GT(*m_last.determinantRatio, 0.0);
}

/// Takes every length for those of one pose, as a solver that does not look at the side may.
class OnePose final : public ForwardSolver {
public:
    ForwardResult solve(const LegLengths&, const Pose&) const noexcept override {
        return {pose, SolveStatus::Converged, 1, 0.0};
    }
    std::string_view name() const noexcept override { return "one-pose"; }
    Pose pose;
};

TEST_F(ControlLoopMotion, AMeasuredPoseBeyondTheSingularOnesStopsTheMotionAndIsReportedAsThat) {
    OnePose solver;
    m_loop = std::make_unique<ControlLoop>(
        m_device, m_model, solver, ControlOptions{}, [this](const Snapshot& s) { take(s); }, m_device.clock(),
        std::make_unique<ImmediatePlanner>(m_model));
    startMoving();
    solver.pose.angles.gamma = radiansFromDeg(140.0);
    cycles(1);
    ASSERT_LT(*m_last.determinantRatio, 0.0);
    ASSERT_GT(*m_last.smallestSingularValue, motionLimits(m_geometry, {}, {}).singularityMargin)
        << "far from singular again";
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_EQ(detailOf(EventCode::StoppedOnLimits), "across the singular poses") << formatEvents(m_events);
    const auto limit = std::find_if(m_events.begin(), m_events.end(),
                                    [](const Event& e) { return e.code == EventCode::StoppedOnLimits; });
    ASSERT_NE(limit, m_events.end());
    EXPECT_DOUBLE_EQ(limit->get<MotionCheck>()->value, *m_last.determinantRatio);
    EXPECT_EQ(limit->get<MotionCheck>()->bound, 0.0);
}

TEST_F(ControlLoopMotion, ARefusalThatRepeatsIsReportedOnceASecond) {
    enable();
    for (int cycle = 0; cycle < 300; ++cycle) {
        m_device.notices.push_back(notice::Refused{deviceRefusalFromWords("SET RANGE leg 2")});
        cycles(1);
    }
    EXPECT_EQ(count(EventCode::ControllerRefused), 3);
}

TEST_F(ControlLoopMotion, APlanThatComesWithTheRunIsUsedIfItStillFits) {
    enable();
    MotionLimits limits = motionLimits(m_geometry, {}, {});
    const ControlOptions options = withDefaults(ControlOptions{}, m_geometry);
    limits.legSpeed = options.bounds.legSpeed;
    limits.legAcceleration = options.bounds.legAcceleration;
    const auto planFor = [&](const MotionLimits& under) {
        return std::make_shared<const PlannedMotion>(planMotion(
            *m_model, options.bounds, under, options.settleWindow.distance,
            {*m_last.commandedLengths, *m_last.measuredPose}, StraightMove{target(), MotionMode::Workspace}));
    };
    m_loop->post(RunCommand{target(), MotionMode::Workspace, 42, planFor(limits)});
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Moving);
    EXPECT_EQ(m_last.motionId, 42U);
    until(RunState::Enabled);
    // One made under other limits is not believed: the motion is planned anew, under those that hold.
    Pose high = target();
    high.offset.z() = 0.090;
    limits.maxLength.setConstant(1.0);
    const auto wide = std::make_shared<const PlannedMotion>(planMotion(
        *m_model, options.bounds, limits, options.settleWindow.distance,
        {*m_last.commandedLengths, *m_last.measuredPose}, StraightMove{high, MotionMode::Workspace}));
    ASSERT_TRUE(wide->check.ok());
    m_events.clear();
    m_loop->post(RunCommand{high, MotionMode::Workspace, 43, wide});
    cycles(2);
    EXPECT_NE(detailOf(EventCode::MoveRefused).find("above max_mm"), std::string::npos);
    EXPECT_EQ(m_last.motionId, 42U);
}

/// Hands out its plan once the test allows it.
class SlowPlanner final : public Planner {
public:
    explicit SlowPlanner(SharedModel model) : m_planner(std::move(model)) {}
    void submit(const PlanJob& job) override {
        m_planner.submit(job);
        ++submitted;
    }
    SharedPlan take() override { return ready ? m_planner.take() : nullptr; }
    bool ready = false;
    int submitted = 0;

private:
    ImmediatePlanner m_planner;
};

TEST_F(ControlLoopMotion, SetPointsGoOnWhileAMotionIsPlanned) {
    auto owned = std::make_unique<SlowPlanner>(m_model);
    SlowPlanner& planner = *owned;
    rebuild({}, std::move(owned));
    enable();
    std::size_t mark = m_device.received.size();
    run();
    cycles(50);
    EXPECT_EQ(planner.submitted, 1);
    EXPECT_EQ(m_last.state, RunState::Enabled);
    EXPECT_FALSE(m_last.allowed.contains(Command::Run));
    for (std::size_t k = mark; k < m_device.received.size(); ++k)
        EXPECT_TRUE(m_device.received[k].lengths) << "the pose is held meanwhile";
    EXPECT_FALSE(motionWasSentSince(mark));
    planner.ready = true;
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Moving);
    EXPECT_EQ(planner.submitted, 1) << "planned once";
    until(RunState::Enabled);

    // A Stop cancels the plan, and what comes of it later starts nothing.
    planner.ready = false;
    m_loop->post(RunCommand{Pose{}});
    cycles(2);
    m_loop->post(StopCommand{});
    cycles(1);
    EXPECT_EQ(m_device.received.back().request, DeviceRequest::Stop);
    planner.ready = true;
    mark = m_device.received.size();
    cycles(20);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_FALSE(anySetPointSince(mark));
}

/// Planned once per request: the planner beside the loop is asked only where what came does not fit.
TEST_F(ControlLoopMotion, ARunThatBringsItsPlanIsNotPlannedAgain) {
    auto owned = std::make_unique<SlowPlanner>(m_model);
    SlowPlanner& planner = *owned;
    planner.ready = true;
    rebuild({}, std::move(owned));
    enable();
    ControlOptions fast;
    fast.bounds.speed = 10.0;
    fast.bounds.jerk = 100.0;
    ControlOptions slack;
    slack.settleWindow.distance = 0.01;
    const auto planUnder = [&](const ControlOptions& options, const Pose& to, double raised = 0.0) {
        const MotionPlanner beside(m_model, plannerSettings(options, m_geometry));
        PlanStart start{*m_last.commandedLengths, *m_last.measuredPose};
        start.setPoint.array() += raised;
        return std::make_shared<const PlannedMotion>(
            beside.plan(start, StraightMove{to, MotionMode::Workspace}));
    };
    const auto asksThePlanner = [&](const SharedPlan& plan) {
        EXPECT_TRUE(plan->check.ok());
        const int before = planner.submitted;
        m_loop->post(RunCommand{target(), MotionMode::Workspace, 7, plan});
        until(RunState::Moving);
        until(RunState::Enabled);
        m_loop->post(RunCommand{Pose{}, MotionMode::Workspace, 8, planUnder({}, Pose{})});
        until(RunState::Moving);
        until(RunState::Enabled);
        return planner.submitted - before;
    };
    EXPECT_EQ(asksThePlanner(planUnder({}, target())), 0);
    EXPECT_EQ(asksThePlanner(planUnder({}, Pose{})), 1) << "of another target";
    EXPECT_EQ(asksThePlanner(planUnder(fast, target())), 1) << "with other bounds";
    EXPECT_EQ(asksThePlanner(planUnder(slack, target())), 1) << "with more slack at the strokes";
    EXPECT_EQ(asksThePlanner(planUnder({}, target(), 0.005)), 1) << "from another start";
}

TEST_F(ControlLoopMotion, APlanWhoseStartIsLeftIsMadeAnewAndThenRefused) {
    auto owned = std::make_unique<SlowPlanner>(m_model);
    SlowPlanner& planner = *owned;
    planner.ready = true;
    rebuild({}, std::move(owned));
    m_device.lengths = m_geometry.homeLengths().array() + 0.01; // referencing moves them home
    cycles(2);
    run();
    until(RunState::Moving);
    EXPECT_EQ(planner.submitted, 2)
        << "once to check the target, and once from where the referencing has led";
    until(RunState::Enabled);
    EXPECT_LT((m_last.measuredPose->offset - target().offset).norm(), kSettleWindow);
}

} // namespace
} // namespace hexapose
