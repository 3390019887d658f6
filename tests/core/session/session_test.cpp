// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The loop on its own thread, through a real pseudo-terminal and serial channel, without an event loop of Qt.
#include "core/session/session.h"

#include "core/base/input_error.h"
#include "core/base/text_file.h"
#include "core/device/line/line_device.h"
#include "core/device/reconnecting_device.h"
#include "core/device/serial/serial_channel.h"
#include "core/device/simulation/virtual_platform_server.h"
#include "core/geometry/geometry_file.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/record/event_codec.h"

#include <QCoreApplication>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sched.h>

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <thread>
#include <type_traits>

namespace hexapose {
namespace {

struct UnnamedConnection {};
static_assert(std::is_invocable_v<const ConnectionName&, SerialConnection>);
static_assert(!std::is_invocable_v<const ConnectionName&, UnnamedConnection>,
              "a kind of connection without a name in the log must not compile");

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr auto kPatience = 60s; // only against hanging

class SessionTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        static int argc = 1;
        static char name[] = "session_test";
        static char* argv[] = {name, nullptr};
        static const QCoreApplication application(argc, argv);
    }

    SessionTest()
        : geometry(loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml")),
          folder(fs::path(testing::TempDir()) /
                 ("hexapose_session_" +
                  std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        fs::remove_all(folder);
        fs::create_directories(folder);
        VirtualPlatformServerOptions patient; // a busy machine may hold a thread up
        patient.platform.watchdog = 10min;
        server = std::make_unique<VirtualPlatformServer>(geometry, patient);
    }
    ~SessionTest() override { fs::remove_all(folder); }

    SessionSetup setup() const {
        SessionSetup setup;
        setup.model = model;
        setup.solver = std::make_shared<NewtonRaphson>(geometry, NewtonOptions{});
        setup.logDirectory = folder;
        setup.control.staleAfter = 60s;
        setup.control.echoWithin = 60s;
        return setup;
    }
    static std::unique_ptr<PlatformDevice> makeDevice(const ConnectionSpec& connection) {
        const auto& serial = std::get<SerialConnection>(connection);
        return std::make_unique<ReconnectingDevice>([serial] {
            return std::make_unique<LineDevice>(std::make_unique<SerialChannel>(serial.path, serial.baud));
        });
    }
    ConnectionSpec connection() const { return SerialConnection{server->path()}; }

    /// Takes from the reader until one of its snapshots fits.
    static bool waitFor(SnapshotReader& reader, const std::function<bool(const Snapshot&)>& fits) {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (std::chrono::steady_clock::now() < end) {
            reader.wait(100ms);
            for (const SnapshotPtr& snapshot : reader.take())
                if (fits(*snapshot))
                    return true;
        }
        return false;
    }
    static bool hasEvent(const Snapshot& snapshot, EventCode code) {
        return std::any_of(snapshot.events.begin(), snapshot.events.end(),
                           [code](const Event& event) { return event.code == code; });
    }

    PlatformGeometry geometry;
    SharedModel model = makeModel(geometry);
    fs::path folder;
    std::unique_ptr<VirtualPlatformServer> server;
};

TEST_F(SessionTest, RunsTheLoopOnAThreadOfItsOwnAndLeavesThePlatformDisabled) {
    Session session(setup(), makeDevice);
    SnapshotReader screen = session.reader();
    SnapshotReader bridge = session.reader();
    session.post(RunCommand{Pose{}, MotionMode::Joint}); // closed: nowhere to go
    EXPECT_FALSE(session.isOpen());
    session.open(connection(), folder / "run.csv");
    EXPECT_TRUE(session.isOpen());
    Pose target;
    target.offset.z() = 0.005;
    ASSERT_TRUE(waitFor(screen, [](const Snapshot& s) { return s.measuredPose.has_value(); }));
    session.post(RunCommand{target, MotionMode::Joint});
    ASSERT_TRUE(waitFor(screen, [](const Snapshot& s) { return hasEvent(s, EventCode::Settled); }));
    session.close();
    EXPECT_FALSE(session.isOpen());
    EXPECT_EQ(session.logFailure(), std::nullopt);
    EXPECT_EQ(session.logFile(), folder / "run.csv");

    std::uint64_t expected = 0;
    int settled = 0;
    for (const SnapshotPtr& snapshot : bridge.take()) {
        EXPECT_EQ(snapshot->cycle, expected++);
        settled += hasEvent(*snapshot, EventCode::Settled) ? 1 : 0;
    }
    EXPECT_EQ(settled, 1);
    // A new connection to the same controller finds it disabled.
    session.open(connection());
    ControllerState found = ControllerState::Unknown;
    ASSERT_TRUE(waitFor(screen, [&](const Snapshot& s) {
        found = s.controllerState;
        return s.fresh && s.controllerState != ControllerState::Unknown;
    }));
    EXPECT_NE(found, ControllerState::Enabled);
}

TEST_F(SessionTest, TellsOnTheScreenAndInTheLogWhatBecomesOfTheLog) {
    SessionSetup tight = setup();
    tight.log.freeSpace = [](const fs::path&) { return std::optional<std::uint64_t>(1'000'000'000); };
    Session session(tight, makeDevice);
    SnapshotReader screen = session.reader();
    session.open(connection(), folder / "run.csv");
    ASSERT_TRUE(waitFor(screen, [](const Snapshot& s) { return hasEvent(s, EventCode::LogSpaceLow); }));
    fs::remove(folder / "run.csv");
    ASSERT_TRUE(waitFor(screen, [](const Snapshot& s) { return hasEvent(s, EventCode::LogContinued); }));
    session.close();
    EXPECT_EQ(session.logFailure(), std::nullopt);
    EXPECT_FALSE(fs::exists(folder / "run.csv"));
    const std::string log = readTextFile(folder / "run-2.csv");
    EXPECT_THAT(log, testing::HasSubstr("log-space-low 1.00 GB"));
    EXPECT_THAT(log, testing::HasSubstr("log-continued run-2.csv: the file before it was deleted"));
}

TEST_F(SessionTest, DestroyedInMidMoveItStopsAndDisables) {
    {
        Session session(setup(), makeDevice);
        SnapshotReader reader = session.reader();
        session.open(connection());
        ASSERT_TRUE(waitFor(reader, [](const Snapshot& s) { return s.measuredPose.has_value(); }));
        Pose target;
        target.offset.z() = 0.040;
        session.post(RunCommand{target, MotionMode::Joint});
        ASSERT_TRUE(waitFor(reader, [](const Snapshot& s) { return s.state == RunState::Moving; }));
    }
    Session again(setup(), makeDevice);
    SnapshotReader reader = again.reader();
    again.open(connection());
    ControllerState found = ControllerState::Unknown;
    ASSERT_TRUE(waitFor(reader, [&](const Snapshot& s) {
        found = s.controllerState;
        return s.fresh && s.controllerState != ControllerState::Unknown;
    }));
    EXPECT_NE(found, ControllerState::Enabled);
}

TEST_F(SessionTest, ADeviceThatCannotBeMadeEndsTheLoopWithTheReason) {
    Session session(setup(), [](const ConnectionSpec&) -> std::unique_ptr<PlatformDevice> {
        throw std::runtime_error("no such thing");
    });
    SnapshotReader reader = session.reader();
    session.open(connection());
    std::string words;
    ASSERT_TRUE(waitFor(reader, [&](const Snapshot& s) {
        if (hasEvent(s, EventCode::LoopFailed))
            words = formatEvent(s.events.front());
        return !words.empty();
    }));
    EXPECT_EQ(words, "loop-failed no such thing");
    EXPECT_TRUE(session.isOpen()) << "until it is closed";
    session.close();
}

TEST_F(SessionTest, AnExistingLogIsRefusedAndNothingIsOpened) {
    Session session(setup(), makeDevice);
    session.open(connection(), folder / "run.csv");
    session.close();
    EXPECT_THROW(session.open(connection(), folder / "run.csv"), InputError);
    EXPECT_FALSE(session.isOpen());
}

/// The policy of the loop's thread, as the thread itself sees it, when its session is opened by a thread of
/// the policy given; nothing where that is not permitted.
std::optional<std::pair<int, SessionInfo>> policyOfLoop(int openerPolicy, int openerPriority,
                                                        const SessionSetup& setup) {
    std::optional<std::pair<int, SessionInfo>> found;
    std::jthread opener([&] {
        const sched_param wanted{openerPriority};
        if (openerPolicy != SCHED_OTHER && pthread_setschedparam(pthread_self(), openerPolicy, &wanted) != 0)
            return;
        std::atomic<int> policy{-1};
        Session session(setup, [&](const ConnectionSpec&) -> std::unique_ptr<PlatformDevice> {
            policy = sched_getscheduler(0);
            throw std::runtime_error("enough");
        });
        SnapshotReader reader = session.reader();
        session.open(VirtualConnection{});
        while (!reader.wait(100ms)) {
        }
        found.emplace(policy.load(), session.info());
    });
    opener.join();
    return found;
}

TEST_F(SessionTest, TheLoopKeepsTheRealTimePolicyThatTheProcessWasGiven) {
    const auto found = policyOfLoop(SCHED_FIFO, 2, setup());
    if (!found)
        GTEST_SKIP() << "SCHED_FIFO is not permitted here";
    EXPECT_EQ(found->first, SCHED_FIFO);
    ASSERT_TRUE(found->second.priority);
    EXPECT_EQ(found->second.priority->policy, ThreadPriority::Policy::Fifo);
    EXPECT_EQ(found->second.priority->level, 2);
    EXPECT_TRUE(found->second.priority->inherited);
}

TEST_F(SessionTest, TheLoopGetsTheBestPriorityThatIsPermittedAndSaysWhich) {
    const auto found = policyOfLoop(SCHED_OTHER, 0, setup());
    ASSERT_TRUE(found && found->second.priority);
    const ThreadPriority& priority = *found->second.priority;
    EXPECT_EQ(priority.policy, found->first == SCHED_RR ? ThreadPriority::Policy::RoundRobin
                                                        : ThreadPriority::Policy::Ordinary);
    EXPECT_FALSE(priority.inherited);
    bool permitted = false;
    std::jthread([&] {
        const sched_param lowest{1};
        permitted = pthread_setschedparam(pthread_self(), SCHED_RR, &lowest) == 0;
    }).join();
    EXPECT_EQ(priority.isRealTime(), permitted);
}

} // namespace
} // namespace hexapose
