// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/events.h"
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/console/report/report_panel.h"

#include <QDir>
#include <QFileInfo>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace hexapose::testing;

class ReportPanelTest : public ::testing::Test {
protected:
    ReportPanelTest() : geometry(laboratoryPlatform()), panel(makeModel(geometry)) {
        panel.setSolver(newtonSolver(geometry));
        panel.setConnected(true);
        panel.setDefaultFolder(folder.path() + QStringLiteral("/run-report"));
        QObject::connect(&panel, &ReportPanel::runRequested, [this](const Pose& pose, MotionId id) {
            asked = pose;
            askedId = id;
        });
    }

    Snapshot at(const Pose& pose, RunState state, MotionId id, std::vector<Event> events = {}) {
        Snapshot snapshot = snapshotAt(geometry, pose, pose, state, now += 0.01);
        snapshot.motionId = id;
        snapshot.events = std::move(events);
        return snapshot;
    }
    /// The move that was asked for last, or somebody's, settled, and `standing` seconds of standing there.
    void move(const Pose& to, double standing = 1.5, std::optional<MotionId> id = {}) {
        const MotionId its = id.value_or(askedId);
        panel.add(at(to, RunState::Moving, its, {{EventCode::MoveStarted, 1.0}}));
        panel.add(at(to, RunState::Enabled, its, {{EventCode::Settled, 1.0}}));
        for (double t = 0.0; t < standing; t += 0.01) {
            panel.add(at(to, RunState::Enabled, its));
        }
    }
    QPushButton* button(const char* name) {
        return qobject_cast<QPushButton*>(findByName(panel, QString::fromLatin1(name)));
    }

    PlatformGeometry geometry;
    QTemporaryDir folder;
    ReportPanel panel;
    std::optional<Pose> asked;
    MotionId askedId = kNoMotion;
    double now = 0.0;
};

constexpr int kReportPatienceMs = 60000;

/// The files are written on a thread of their own.
bool comes(QSignalSpy& signal) {
    return signal.count() == 1 || signal.wait(kReportPatienceMs);
}

TEST_F(ReportPanelTest, ASettledRunIsASampleAndIsExportedBesideTheLog) {
    QSignalSpy exported(&panel, &ReportPanel::exported);
    move(poseOf(12, -4, 40, 0, 0, 5));
    ASSERT_EQ(panel.sampleCount(), 1);
    auto* table = qobject_cast<QTableWidget*>(findByName(panel, QStringLiteral("Samples")));
    EXPECT_EQ(table->item(0, 3)->text(), "40.00");
    panel.exportReport();
    ASSERT_TRUE(comes(exported));
    for (const char* file : {"report.pdf", "errors.csv", "errors.png", "errors.svg"}) {
        const QFileInfo info(folder.path() + QStringLiteral("/run-report/") + QString::fromLatin1(file));
        EXPECT_GT(info.size(), 0) << file;
        EXPECT_TRUE(spokenText(panel, QStringLiteral("Report files")).contains(info.filePath())) << file;
    }
}

TEST_F(ReportPanelTest, ExportBeforeTheFirstSampleHappensWithIt) {
    QSignalSpy exported(&panel, &ReportPanel::exported);
    QSignalSpy noted(&panel, &ReportPanel::noted);
    panel.exportReport();
    EXPECT_EQ(exported.count(), 0);
    EXPECT_EQ(noted.count(), 1);
    move(poseOf(5, 0, 0, 0, 0, 0));
    EXPECT_TRUE(comes(exported));
}

TEST_F(ReportPanelTest, ListIsRunThroughOneByOne) {
    QSignalSpy finished(&panel, &ReportPanel::finished);
    const std::vector<Pose> list{poseOf(1, 0, 0, 0, 0, 0), poseOf(2, 0, 0, 0, 0, 0),
                                 poseOf(3, 0, 0, 0, 0, 0)};
    panel.runList(list);
    EXPECT_FALSE(button("Run report")->isEnabled());
    panel.add(snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, now));
    for (const Pose& pose : list) {
        ASSERT_TRUE(asked);
        EXPECT_TRUE(asked->toVector().isApprox(pose.toVector()));
        asked.reset();
        move(pose);
    }
    ASSERT_EQ(finished.count(), 1);
    EXPECT_TRUE(finished.first().first().toBool());
    EXPECT_EQ(panel.sampleCount(), 3);
    EXPECT_FALSE(panel.isRunning());
    EXPECT_TRUE(button("Run report")->isEnabled());
}

TEST_F(ReportPanelTest, AnotherMotionEndsTheListAndThatIsTold) {
    panel.runReport();
    panel.add(snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, now));
    ASSERT_TRUE(asked);
    move(*asked, 0.5);
    EXPECT_TRUE(panel.isRunning());
    move(poseOf(1, 0, 0, 0, 0, 0), 1.5, 1234); // somebody else's
    EXPECT_FALSE(panel.isRunning());
    EXPECT_EQ(spokenText(panel, QStringLiteral("Report progress")),
              "Ended early: another motion was commanded");
    panel.runReport();
    panel.stopped();
    EXPECT_FALSE(panel.isRunning());
    EXPECT_EQ(spokenText(panel, QStringLiteral("Report progress")), "Ended early: Stop was pressed");
}

TEST_F(ReportPanelTest, SamplesAreDiscardedOnlyWhenTheLoopTakesTheRun) {
    move(poseOf(5, 0, 0, 0, 0, 0));
    ASSERT_EQ(panel.sampleCount(), 1);
    panel.runReport();
    Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, now);
    panel.add(snapshot);
    EXPECT_EQ(panel.sampleCount(), 1);
    snapshot.events.push_back(
        {EventCode::CommandRefused, CommandRefusal{Command::Run, RunState::Moving, CommandSet{}, askedId}});
    panel.add(snapshot);
    EXPECT_FALSE(panel.isRunning());
    EXPECT_EQ(panel.sampleCount(), 1) << "refused: they stay";
    panel.runReport();
    panel.add(snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, now));
    ASSERT_TRUE(asked);
    move(*asked, 0.1);
    EXPECT_EQ(panel.sampleCount(), 0);
}

TEST_F(ReportPanelTest, RunReportIsGreyWhereTheLoopWouldRefuseIt) {
    const auto show = [this](RunState state) {
        panel.showSnapshot(snapshotAt(geometry, Pose{}, Pose{}, state, now));
        return button("Run report")->isEnabled();
    };
    EXPECT_TRUE(show(RunState::Enabled));
    EXPECT_FALSE(show(RunState::Moving));
    EXPECT_EQ(button("Run report")->toolTip(), "Cannot run while the platform moves");
    EXPECT_FALSE(show(RunState::Stopped));
    EXPECT_TRUE(show(RunState::Disabled));
}

TEST_F(ReportPanelTest, RefusedMoveEndsTheList) {
    QSignalSpy finished(&panel, &ReportPanel::finished);
    panel.runReport();
    Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, now);
    panel.add(snapshot);
    ASSERT_TRUE(asked); // the first of the default list
    EXPECT_LE(asked->offset.cwiseAbs().maxCoeff(), 0.010);
    snapshot.events.push_back(eventFrom("move-refused leg 3 above max_mm"));
    panel.add(snapshot);
    ASSERT_EQ(finished.count(), 1);
    EXPECT_FALSE(finished.first().first().toBool());
    EXPECT_TRUE(spokenText(panel, QStringLiteral("Report progress")).contains(QStringLiteral("Leg 3")));
}

TEST_F(ReportPanelTest, FolderThatCannotBeWrittenIsTold) {
    QSignalSpy exported(&panel, &ReportPanel::exported);
    move(poseOf(5, 0, 0, 0, 0, 0));
    panel.setFolder(QStringLiteral("/proc/none/of/this"));
    panel.exportReport();
    const auto told = [&] {
        return spokenText(panel, QStringLiteral("Report files")).contains(QStringLiteral("/proc/none"));
    };
    EXPECT_TRUE(QTest::qWaitFor(told, kReportPatienceMs));
    EXPECT_EQ(exported.count(), 0);
}

TEST_F(ReportPanelTest, ARelativeFolderIsToldAsAWholePath) {
    const QString before = QDir::currentPath();
    ASSERT_TRUE(QDir::setCurrent(folder.path()));
    QSignalSpy exported(&panel, &ReportPanel::exported);
    move(poseOf(5, 0, 0, 0, 0, 0));
    panel.setFolder(QStringLiteral("relative"));
    panel.exportReport();
    EXPECT_TRUE(comes(exported));
    const QString file = QDir::current().absoluteFilePath(QStringLiteral("relative/report.pdf"));
    EXPECT_TRUE(spokenText(panel, QStringLiteral("Report files")).contains(file));
    EXPECT_TRUE(QFileInfo::exists(file));
    QDir::setCurrent(before);
}

} // namespace
} // namespace hexapose
