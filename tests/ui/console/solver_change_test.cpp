// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Another solver for a running loop: between two cycles, while nothing moves, and told.
#include "core/finite_step/finite_step_solver.h"
#include "core/record/event_codec.h"
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/console/events/event_list.h"
#include "ui/console/status/status_panel.h"
#include "ui/console/window/operator_window.h"

#include <QComboBox>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <functional>

namespace hexapose {
namespace {

using namespace hexapose::testing;
constexpr int kLongestWaitMs = 20000; // only against hanging

class SolverChangeTest : public ::testing::Test {
protected:
    SolverChangeTest()
        : geometry(laboratoryPlatform()),
          fsi(std::make_shared<FiniteStepSolver>(geometry, FiniteStepOptions{.steps = 100})) {}
    std::unique_ptr<Session> makeSession() {
        SessionSetup setup;
        setup.model = makeModel(geometry);
        setup.solver = newtonSolver(geometry);
        setup.logDirectory = folder.path().toStdString();
        return std::make_unique<Session>(
            setup, [this](const ConnectionSpec&) { return std::make_unique<InstantDevice>(geometry); });
    }
    bool waitFor(const std::function<bool()>& condition) {
        return QTest::qWaitFor(condition, kLongestWaitMs);
    }

    QTemporaryDir folder;
    PlatformGeometry geometry;
    std::shared_ptr<const ForwardSolver> fsi;
};

bool changes(const Snapshot& snapshot) {
    return std::any_of(snapshot.events.begin(), snapshot.events.end(),
                       [](const Event& event) { return event.code == EventCode::SolverChanged; });
}

/// Asked for in mid-move: the move ends with the solver that it began with, no cycle is left out, and each
/// one has a pose.
TEST_F(SolverChangeTest, WaitsForTheEndOfAMoveAndLosesNoCycle) {
    const std::unique_ptr<Session> session = makeSession();
    const std::shared_ptr<const ForwardSolver> newton = session->solver();
    session->open(VirtualConnection{});
    SnapshotReader reader = session->reader();
    std::vector<Snapshot> all;
    const auto waitUntil = [&](const std::function<bool(const Snapshot&)>& condition) {
        return waitFor([&] {
            for (const SnapshotPtr& snapshot : reader.take()) {
                all.push_back(*snapshot);
            }
            return !all.empty() && condition(all.back());
        });
    };
    ASSERT_TRUE(waitUntil([](const Snapshot& last) { return last.measuredPose.has_value(); }));
    session->post(RunCommand{poseOf(2, 0, 0, 0, 0, 1), MotionMode::Workspace});
    ASSERT_TRUE(waitUntil([](const Snapshot& last) { return last.state == RunState::Moving; }));
    session->setSolver(fsi, "abc");
    EXPECT_EQ(session->setup().solver, fsi) << "also for the next connection";
    ASSERT_TRUE(waitUntil([&](const Snapshot&) { return session->solver() == fsi; }));
    const std::size_t changed = all.size();
    ASSERT_TRUE(waitUntil([&](const Snapshot&) { return all.size() > changed + 20; }));
    session->close();
    int told = 0;
    for (std::size_t i = 1; i < all.size(); ++i) {
        EXPECT_EQ(all[i].cycle, all[i - 1].cycle + 1);
        EXPECT_TRUE(all[i].measuredPose.has_value() || !all[i].measuredLengths) << all[i].cycle;
        if (!changes(all[i])) {
            continue;
        }
        ++told;
        EXPECT_EQ(formatEvent(all[i].events.front()), "solver-changed fsi abc");
        EXPECT_NE(all[i - 1].state, RunState::Moving);
        EXPECT_NE(all[i - 1].state, RunState::Settling);
        EXPECT_GT(all[i].iterations, 50) << "steps, from this cycle on";
    }
    EXPECT_EQ(told, 1);
    EXPECT_NE(newton, fsi);
}

TEST_F(SolverChangeTest, TheWindowFollows) {
    OperatorWindow window(makeModel(geometry), [] { return QStringList(); });
    window.setSession(makeSession());
    window.show();
    const auto box = [&] { return qobject_cast<QComboBox*>(findByName(window, QStringLiteral("Solver"))); };
    const auto inUse = [&] {
        return spokenText(*window.findChild<StatusPanel*>(), QStringLiteral("Solver"));
    };
    ASSERT_NE(box(), nullptr);
    EXPECT_EQ(box()->currentText(), "Newton");
    EXPECT_EQ(inUse(), "Newton");
    window.setSolver(fsi, {}); // closed: at once
    EXPECT_EQ(box()->currentText(), "FSI");
    EXPECT_EQ(inUse(), "FSI");
    window.connectTo(VirtualConnection{});
    ASSERT_TRUE(waitFor([&] { return spokenText(window, QStringLiteral("Measured x")) == "0.000"; }));
    window.setSolver(newtonSolver(geometry), {});
    EXPECT_EQ(box()->currentText(), "Newton");
    ASSERT_TRUE(waitFor([&] { return inUse() == "Newton"; }));
    bool told = false;
    ASSERT_TRUE(waitFor([&] {
        for (int i = 0; i < window.events().count(); ++i) {
            told = told || window.events().textAt(i).contains(QStringLiteral("The solver is now Newton"));
        }
        return told;
    }));
    // Closed before the loop has taken it: the next connection begins with it.
    window.setSolver(fsi, {});
    window.disconnectFrom();
    EXPECT_EQ(inUse(), "FSI");
}

} // namespace
} // namespace hexapose
