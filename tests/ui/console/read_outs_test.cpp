// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/common/read_out.h"
#include "ui/common/theme.h"
#include "ui/console/status/legs_panel.h"
#include "ui/console/status/pose_panel.h"
#include "ui/console/status/settle_line.h"
#include "ui/console/status/status_panel.h"

#include <QLabel>

#include <gtest/gtest.h>

#include <numbers>

namespace hexapose {
namespace {

using namespace hexapose::testing;

QString spoken(QWidget& root, const char* name) {
    return spokenText(root, QString::fromLatin1(name));
}
bool stale(QWidget& root, const char* name) {
    auto* readOut = qobject_cast<ReadOut*>(findByName(root, QString::fromLatin1(name)));
    return readOut != nullptr && readOut->isStale();
}

TEST(PosePanel, ShowsPathMeasuredAndErrorInMmAndDegrees) {
    const PlatformGeometry geometry = laboratoryPlatform();
    PosePanel panel(makeModel(geometry));
    panel.showSnapshot(snapshotAt(geometry, poseOf(12.003, -4, 40, 0, 0.25, 5.01),
                                  poseOf(12, -4, 40, 0, 0, 5), RunState::Enabled, 1.0));
    EXPECT_EQ(spoken(panel, "Measured x"), "12.003");
    EXPECT_EQ(spoken(panel, "Error x"), "0.003");
    EXPECT_EQ(spoken(panel, "Path x"), "12.000");
    EXPECT_EQ(spoken(panel, "Measured beta"), "0.2500");
    EXPECT_EQ(spoken(panel, "Error gamma"), "0.0100");
    EXPECT_EQ(spoken(panel, "Error z"), "0.000");
    EXPECT_GT(spoken(panel, "Expected error x").toDouble(), 0.0);
    EXPECT_FALSE(stale(panel, "Measured x"));
    QStringList heads;
    for (const auto* label : panel.findChildren<QLabel*>()) {
        heads << label->text();
    }
    EXPECT_TRUE(heads.contains(QStringLiteral("path")));
    EXPECT_FALSE(heads.contains(QStringLiteral("target"))) << "that is what the motion ends at";
}

TEST(PosePanel, NeverShowsAPoseWithoutAUsableSolution) {
    const PlatformGeometry geometry = laboratoryPlatform();
    PosePanel panel(makeModel(geometry));
    Snapshot snapshot = snapshotAt(geometry, poseOf(12, 0, 0, 0, 0, 0), Pose{}, RunState::Enabled, 1.0);
    panel.showSnapshot(snapshot);
    snapshot.measuredPose.reset();
    snapshot.status = SolveStatus::NoSolution;
    panel.showSnapshot(snapshot);
    for (const char* name : {"Measured x", "Measured gamma", "Error x", "Error gamma", "Expected error x"}) {
        EXPECT_EQ(spoken(panel, name), "--") << name;
    }
    EXPECT_EQ(spoken(panel, "Path x"), "0.000");
}

TEST(StatusPanel, AStateThatIsNotKnownIsNotShown) {
    const PlatformGeometry geometry = laboratoryPlatform();
    StatusPanel panel;
    Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, RunState::Disabled, 1.0);
    panel.showSnapshot(snapshot);
    EXPECT_EQ(spoken(panel, "State"), "Disabled");
    snapshot.stale = true;
    panel.showSnapshot(snapshot);
    EXPECT_EQ(spoken(panel, "State"), "No data");
    snapshot.state = RunState::Stopped; // by ourselves
    panel.showSnapshot(snapshot);
    EXPECT_EQ(spoken(panel, "State"), "Stopped");
    snapshot = snapshotAt(geometry, Pose{}, Pose{}, RunState::Disabled, 1.0);
    snapshot.link = LinkState::ListenOnly;
    panel.showSnapshot(snapshot);
    EXPECT_EQ(spoken(panel, "State"), "Not known");
    panel.showSnapshot({});
    EXPECT_EQ(spoken(panel, "State"), "Disconnected");
}

TEST(PosePanel, ShowsHowFarFromSingularItIs) {
    const PlatformGeometry geometry = laboratoryPlatform();
    PosePanel panel(makeModel(geometry));
    EXPECT_EQ(spoken(panel, "Singularity margin q"), "--");
    Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, 1.0);
    QWidget* q = findByName(panel, QStringLiteral("Singularity margin q"));
    const std::pair<double, Tone> zones[] = {{0.98, Tone::Idle}, {0.2, Tone::Idle},  {0.19, Tone::Warn},
                                             {0.05, Tone::Warn}, {0.049, Tone::Bad}, {-0.3, Tone::Bad}};
    for (const auto& [value, tone] : zones) {
        snapshot.determinantRatio = value;
        panel.showSnapshot(snapshot);
        EXPECT_NEAR(spoken(panel, "Singularity margin q").toDouble(), value, 1e-3);
        EXPECT_EQ(toneOf(*q), tone) << value;
    }
    snapshot.stale = true;
    panel.showSnapshot(snapshot);
    EXPECT_TRUE(stale(panel, "Singularity margin q"));
    snapshot.measuredPose.reset();
    panel.showSnapshot(snapshot);
    EXPECT_EQ(spoken(panel, "Singularity margin q"), "--");
}

TEST(SettleLine, SaysTheWindowAndTheTime) {
    const PlatformGeometry geometry = laboratoryPlatform();
    SettleLine line(makeModel(geometry));
    ControlOptions options;
    options.settleWindow = {0.0002, 0.1 * std::numbers::pi / 180.0};
    line.setControl(options);
    Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, RunState::Moving, 1.0);
    snapshot.mode = MotionMode::Workspace;
    const auto show = [&](RunState state) {
        snapshot.state = state;
        line.add(snapshot);
        line.showSnapshot(snapshot);
        return spoken(line, "Settled");
    };
    EXPECT_EQ(show(RunState::Moving), "Moving");
    EXPECT_TRUE(
        show(RunState::Settling).startsWith(QStringLiteral("Not settled yet: within 0.20 mm and 0.10")));
    EXPECT_EQ(show(RunState::Enabled), "--") << "nobody said that it has settled";
    snapshot.events.push_back({EventCode::Settled, 1.0});
    EXPECT_EQ(show(RunState::Enabled), QString::fromUtf8("Settled: within 0.20 mm and 0.10\u00b0 for 0.3 s"));
    snapshot.events.clear();
    snapshot.mode = MotionMode::Joint;
    EXPECT_EQ(show(RunState::Enabled), "Settled: each leg within 0.20 mm for 0.3 s");
    EXPECT_EQ(show(RunState::Stopped), "--");
    EXPECT_EQ(show(RunState::Enabled), "--");
}

TEST(LegsPanel, ShowsCommandedMeasuredAndErrorAndGreysOldValues) {
    const PlatformGeometry geometry = laboratoryPlatform();
    LegsPanel panel(makeModel(geometry));
    EXPECT_EQ(spoken(panel, "Leg 1 measured"), "--");
    Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, RunState::Moving, 1.0);
    snapshot.commandedLengths = LegLengths::Constant(0.300);
    snapshot.measuredLengths = LegLengths::Constant(0.3001);
    panel.showSnapshot(snapshot);
    for (int leg = 1; leg <= kLegCount; ++leg) {
        EXPECT_EQ(spokenText(panel, QStringLiteral("Leg %1 set-point").arg(leg)), "300.000");
        EXPECT_EQ(spokenText(panel, QStringLiteral("Leg %1 measured").arg(leg)), "300.100");
        EXPECT_EQ(spokenText(panel, QStringLiteral("Leg %1 error").arg(leg)), "0.100");
    }
    EXPECT_FALSE(stale(panel, "Leg 6 measured"));
    snapshot.stale = true;
    panel.showSnapshot(snapshot);
    EXPECT_TRUE(stale(panel, "Leg 6 measured"));
    EXPECT_FALSE(stale(panel, "Leg 6 set-point"));
}

TEST(StatusPanel, ShowsStateRateAgeAndWhatTheSolverSaid) {
    const PlatformGeometry geometry = laboratoryPlatform();
    StatusPanel panel;
    panel.setSolver("mpr3-nr");
    panel.setPlatform(QStringLiteral("Bench 4"));
    EXPECT_EQ(spoken(panel, "State"), "Disconnected");
    EXPECT_EQ(spoken(panel, "Age"), "--");
    Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, RunState::Moving, 1.0);
    snapshot.counters.droppedCrc = 3;
    snapshot.counters.droppedNumber = 2;
    panel.showSnapshot(snapshot);
    const std::pair<const char*, const char*> expected[] = {
        {"State", "Moving"},     {"Rate", "100.0"},      {"Age", "4"},
        {"Solver", "MPR3-NR"},   {"Iterations", "2"},    {"Residual", "3.0e-10"},
        {"Dropped frames", "5"}, {"Platform", "Bench 4"}};
    for (const auto& [name, text] : expected) {
        EXPECT_EQ(spoken(panel, name), text) << name;
    }
    snapshot.stale = true;
    snapshot.age = std::chrono::milliseconds(2345);
    panel.showSnapshot(snapshot);
    EXPECT_EQ(spoken(panel, "Age"), "2345");
    EXPECT_TRUE(stale(panel, "Age"));
}

} // namespace
} // namespace hexapose
