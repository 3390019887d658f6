// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// What a command changes, when it may, and what goes out at the end of a motion.
#include "core/record/device_words.h"
#include "tests/core/machine/control_loop_fixture.h"

#include <functional>
#include <map>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing::kSettleWindow;
using testing::target;
constexpr MotionId kRunId = 7;
constexpr MotionId kJogId = 8;

class ControlLoopRules : public testing::ControlLoopTest {
protected:
    /// Into a state of the machine, from a new loop and a new controller.
    void bringTo(RunState state, bool held = false) {
        m_device.link = LinkState::Connected;
        m_device.state = ControllerState::Unreferenced;
        m_device.lengths = m_geometry.homeLengths();
        rebuild({});
        m_last = {};
        cycles(2);
        if (state == RunState::Disconnected) {
            m_device.link = LinkState::Connecting;
        } else if (state == RunState::Disabled) {
            m_device.state = ControllerState::Disabled;
        } else if (state == RunState::Stopped) {
            m_loop->post(StopCommand{});
        } else if (state == RunState::Fault) {
            m_device.state = ControllerState::Fault;
        } else if (state != RunState::Unreferenced) {
            startMoving();
            if (held)
                m_loop->post(HoldCommand{});
            if (state != RunState::Moving)
                until(state);
        }
        cycles(3);
        ASSERT_EQ(m_last.state, state);
        ASSERT_EQ(m_last.held, held);
    }
    const std::map<Command, OperatorCommand> m_commands{
        {Command::Run, RunCommand{Pose{{0.0, 0.0, 0.005}, {}}, MotionMode::Joint, kRunId}},
        {Command::Jog, JogCommand{{2, true, JogFrame::Base}, 1.0, kJogId}},
        {Command::Stop, StopCommand{}},
        {Command::Reference, ReferenceCommand{}},
        {Command::Enable, EnableCommand{}},
        {Command::Disable, DisableCommand{}},
        {Command::Clear, ClearCommand{}},
        {Command::Hold, HoldCommand{}},
        {Command::Resume, ResumeCommand{}}};
};

TEST_F(ControlLoopRules, ARefusedCommandChangesNothingAndSendsNothing) {
    int refused = 0;
    for (const auto& [state, held] :
         {std::pair(RunState::Disconnected, false), std::pair(RunState::Unreferenced, false),
          std::pair(RunState::Disabled, false), std::pair(RunState::Enabled, false),
          std::pair(RunState::Moving, false), std::pair(RunState::Moving, true),
          std::pair(RunState::Settling, false), std::pair(RunState::Stopped, false),
          std::pair(RunState::Fault, false)}) {
        for (const auto& [command, posted] : m_commands) {
            bringTo(state, held);
            SCOPED_TRACE(std::string(toWord(command)) + " in " + std::string(toWord(state)) +
                         (held ? ", held" : ""));
            if (m_last.allowed.contains(command))
                continue;
            ++refused;
            const Snapshot before = m_last;
            const std::size_t mark = m_device.received.size();
            m_events.clear();
            m_loop->post(posted);
            cycles(1);
            ASSERT_EQ(m_events.size(), 1U) << formatEvents(m_events);
            EXPECT_EQ(m_events[0].code, EventCode::CommandRefused);
            EXPECT_EQ(payloadWords(m_events[0]),
                      std::string(toWord(command)) + " in " + std::string(toWord(state)));
            const auto* refusal = m_events[0].get<CommandRefusal>();
            ASSERT_NE(refusal, nullptr);
            EXPECT_EQ(refusal->allowed, before.allowed) << "what could be asked for in its place";
            EXPECT_EQ(refusal->id, command == Command::Run   ? kRunId
                                   : command == Command::Jog ? kJogId
                                                             : kNoMotion);
            EXPECT_EQ(m_last.state, before.state);
            EXPECT_EQ(m_last.held, before.held);
            EXPECT_EQ(m_last.allowed, before.allowed);
            EXPECT_EQ(m_last.motionId, before.motionId);
            EXPECT_EQ(m_last.goalPose.has_value(), before.goalPose.has_value());
            EXPECT_TRUE(requestsSince(mark).empty());
            EXPECT_EQ(m_device.received.back().lengths.has_value(), before.commandedLengths.has_value());
            if (held) {
                cycles(100);
                EXPECT_TRUE(m_last.held);
                const auto there = m_device.received.back().lengths;
                cycles(20);
                EXPECT_EQ(m_device.received.back().lengths, there) << "it does not go on";
            }
        }
    }
    EXPECT_GT(refused, 40);
}

TEST_F(ControlLoopRules, EveryAllowedCommandIsAccepted) {
    for (const RunState state : {RunState::Unreferenced, RunState::Disabled, RunState::Enabled,
                                 RunState::Moving, RunState::Settling, RunState::Stopped, RunState::Fault})
        for (const auto& [command, posted] : m_commands) {
            bringTo(state);
            if (!m_last.allowed.contains(command))
                continue;
            m_events.clear();
            m_loop->post(posted);
            cycles(1);
            EXPECT_FALSE(saw(EventCode::CommandRefused)) << toWord(command) << " in " << toWord(state);
        }
}

TEST_F(ControlLoopRules, AHoldStaysUntilResume) {
    startMoving();
    m_loop->post(HoldCommand{});
    cycles(50);
    EXPECT_TRUE(m_last.held);
    EXPECT_EQ(m_last.state, RunState::Moving);
    const auto there = m_device.received.back().lengths;
    m_loop->post(SpeedCommand{1.0}); // an override is no resume
    cycles(50);
    EXPECT_EQ(m_device.received.back().lengths, there);
    m_loop->post(ResumeCommand{});
    until(RunState::Enabled);
    EXPECT_FALSE(m_last.held);
    EXPECT_LT((m_last.measuredPose->offset - target().offset).norm(), kSettleWindow);
}

TEST_F(ControlLoopRules, WhateverTheControllerSaysInMidMoveStopAndDisableGoOut) {
    for (const ControllerState says : {ControllerState::Unreferenced, ControllerState::Disabled,
                                       ControllerState::Stopped, ControllerState::Fault}) {
        SCOPED_TRACE(toLetter(says));
        bringTo(RunState::Moving);
        const std::size_t mark = m_device.received.size();
        m_device.state = says;
        m_device.ignoresStop = true;
        cycles(5);
        EXPECT_EQ(requestsSince(mark), (std::vector{DeviceRequest::Stop, DeviceRequest::Disable}));
        EXPECT_EQ(m_device.received[mark].request, DeviceRequest::Stop) << "in the cycle that measured it";
        EXPECT_FALSE(anySetPointSince(mark));
        EXPECT_EQ(m_last.state, says == ControllerState::Fault ? RunState::Fault : RunState::Stopped);
        m_device.ignoresStop = false;
    }
}

TEST_F(ControlLoopRules, AControllerThatRestartsInMidMoveIsStoppedAndDisabledWhileItConnects) {
    for (const LinkState link : {LinkState::Connected, LinkState::Connecting}) {
        bringTo(RunState::Moving);
        m_events.clear();
        const std::size_t mark = m_device.received.size();
        m_device.notices.push_back(notice::ClockWentBack{});
        m_device.link = link;
        cycles(3);
        EXPECT_EQ(requestsSince(mark), (std::vector{DeviceRequest::Stop, DeviceRequest::Disable}));
        EXPECT_FALSE(anySetPointSince(mark));
        EXPECT_EQ(count(EventCode::ClockWentBack), 1);
        EXPECT_NE(m_last.state, RunState::Moving);
    }
}

TEST_F(ControlLoopRules, EveryExitAfterAnythingWasEnabledStopsAndDisables) {
    struct Exit {
        const char* name;
        std::function<void()> before;
        bool enabledByUs;
    };
    const std::vector<Exit> exits{
        {"never enabled", [this] { bringTo(RunState::Disabled); }, false},
        {"at rest", [this] { bringTo(RunState::Enabled); }, true},
        {"in mid-move", [this] { bringTo(RunState::Moving); }, true},
        {"says D",
         [this] {
             bringTo(RunState::Enabled);
             m_device.state = ControllerState::Disabled;
             cycles(2);
         },
         true},
        {"says S",
         [this] {
             bringTo(RunState::Enabled);
             m_device.state = ControllerState::Stopped;
             cycles(2);
         },
         true},
        {"connecting again",
         [this] {
             bringTo(RunState::Moving);
             m_device.link = LinkState::Connecting;
             cycles(2);
         },
         true},
    };
    for (const Exit& exit : exits) {
        SCOPED_TRACE(exit.name);
        exit.before();
        const std::size_t mark = m_device.received.size();
        m_loop->shutDown();
        const std::vector<DeviceRequest> sent = requestsSince(mark);
        EXPECT_FALSE(anySetPointSince(mark));
        if (!exit.enabledByUs) {
            EXPECT_TRUE(sent.empty());
            continue;
        }
        EXPECT_EQ(sent, (std::vector{DeviceRequest::Stop, DeviceRequest::Disable}));
    }
}

TEST_F(ControlLoopRules, NoExitClearsAStop) {
    for (const RunState state : {RunState::Enabled, RunState::Moving, RunState::Stopped}) {
        bringTo(state);
        const std::size_t mark = m_device.received.size();
        m_loop->shutDown();
        for (const DeviceRequest request : requestsSince(mark))
            EXPECT_NE(request, DeviceRequest::Clear);
    }
}

TEST_F(ControlLoopRules, AStopPressedBeforeTheControllerIsKnownIsRemembered) {
    m_device.link = LinkState::Connecting;
    cycles(2);
    m_loop->post(StopCommand{});
    cycles(1);
    EXPECT_EQ(m_device.received.back().request, DeviceRequest::Stop);
    m_device.state = ControllerState::Disabled;
    m_device.link = LinkState::Connected;
    cycles(3);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    m_events.clear();
    run();
    cycles(2);
    EXPECT_TRUE(saw(EventCode::CommandRefused));
}

TEST_F(ControlLoopRules, AStopPressedWhileThePortIsLostIsRememberedAndSentWhenItIsBack) {
    for (const RunState lostIn : {RunState::Unreferenced, RunState::Disabled, RunState::Enabled,
                                  RunState::Moving, RunState::Stopped, RunState::Fault}) {
        SCOPED_TRACE(std::string(toWord(lostIn)));
        bringTo(lostIn);
        m_device.link = LinkState::Lost;
        cycles(3);
        ASSERT_EQ(m_last.state, RunState::Disconnected);
        EXPECT_EQ(m_last.allowed, CommandSet{Command::Stop});
        m_events.clear();
        m_loop->post(StopCommand{});
        cycles(20);
        EXPECT_EQ(count(EventCode::StopRequested), 1);
        EXPECT_FALSE(saw(EventCode::CommandRefused));
        EXPECT_EQ(m_last.state, RunState::Disconnected);

        const std::size_t mark = m_device.received.size();
        m_device.link = LinkState::Connected;
        cycles(20);
        const std::vector<DeviceRequest> sent = requestsSince(mark);
        ASSERT_FALSE(sent.empty());
        EXPECT_EQ(m_device.received[mark].request, DeviceRequest::Stop) << "in the first cycle";
        EXPECT_EQ(sent.size() == 2, lostIn == RunState::Moving) << "lost in mid-move it is disabled, too";
        EXPECT_FALSE(anySetPointSince(mark));
        EXPECT_EQ(m_last.state, lostIn == RunState::Fault ? RunState::Fault : RunState::Stopped);
        EXPECT_FALSE(saw(EventCode::Enabled) || saw(EventCode::Disabled)) << formatEvents(m_events);
        EXPECT_FALSE(m_last.allowed.contains(Command::Run));
        EXPECT_TRUE(m_last.allowed.contains(Command::Clear));

        m_loop->post(ClearCommand{});
        cycles(3);
        EXPECT_EQ(m_last.state, RunState::Disabled);
    }
}

TEST_F(ControlLoopRules, OnlyAListenOnlySenderCannotBeStopped) {
    m_device.link = LinkState::ListenOnly;
    cycles(3);
    EXPECT_EQ(m_last.allowed, CommandSet{});
    m_loop->post(StopCommand{});
    cycles(3);
    EXPECT_EQ(detailOf(EventCode::CommandRefused), "stop in disabled");
    EXPECT_TRUE(requestsSince(0).empty());
}

TEST_F(ControlLoopRules, ClearCountsOnceTheControllerConfirmedIt) {
    enable();
    m_loop->post(StopCommand{});
    cycles(3);
    m_device.ignoresClear = true;
    m_loop->post(ClearCommand{});
    cycles(1);
    m_device.notices.push_back(notice::Refused{{DeviceRequest::Clear, RefusalReason::StopUnconfirmed}});
    m_device.state = ControllerState::Disabled; // left by itself
    cycles(20);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_FALSE(saw(EventCode::Cleared));
    m_device.ignoresClear = false;
    m_loop->post(ClearCommand{});
    cycles(3);
    EXPECT_EQ(m_last.state, RunState::Disabled);
    EXPECT_TRUE(saw(EventCode::Cleared));
}

} // namespace
} // namespace hexapose
