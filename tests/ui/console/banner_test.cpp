// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/events.h"
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/common/language.h"
#include "ui/console/status/banner.h"

#include <QCoreApplication>
#include <QProgressBar>
#include <QRegularExpression>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace hexapose::testing;

QString message(Banner& banner) {
    return spokenText(banner, QStringLiteral("Message"));
}

TEST(Banner, SpeaksUpForWhatMustNotBeMissedAndIsGoneAfterwards) {
    const PlatformGeometry geometry = laboratoryPlatform();
    Banner banner;
    Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, 1.0);
    banner.showSnapshot(snapshot, true);
    EXPECT_TRUE(banner.isHidden());
    snapshot.stale = true;
    snapshot.age = std::chrono::milliseconds(3200);
    banner.showSnapshot(snapshot, true);
    EXPECT_FALSE(banner.isHidden());
    EXPECT_TRUE(message(banner).contains(QStringLiteral("3.2 s")));
    snapshot.link = LinkState::Lost;
    snapshot.events.push_back(eventFrom("link-lost Input/output error"));
    banner.showSnapshot(snapshot, true);
    EXPECT_TRUE(message(banner).contains(QStringLiteral("Input/output error")));
    EXPECT_EQ(toneOf(banner), Tone::Bad);
    snapshot.events.clear();
    snapshot.link = LinkState::ListenOnly;
    snapshot.stale = false;
    banner.showSnapshot(snapshot, true);
    EXPECT_TRUE(message(banner).contains(QStringLiteral("without checksums")));
    banner.showLogFailure(LogFailure{0, "No space left on device"});
    EXPECT_TRUE(message(banner).contains(QStringLiteral("No space left")));
    banner.showLogFailure({});
    banner.showClosed();
    EXPECT_TRUE(banner.isHidden());
}

TEST(Banner, TellsTheEndOfTheLoopFromALossOfTheConnection) {
    Banner banner;
    Snapshot snapshot; // as the session makes it when the loop is over
    snapshot.state = RunState::Fault;
    snapshot.link = LinkState::Lost;
    snapshot.events.push_back(eventFrom("loop-failed X4"));
    banner.showSnapshot(snapshot, true);
    EXPECT_EQ(message(banner),
              "The control loop ended: internal error \"X4\". Disconnect and connect again.");
    EXPECT_EQ(toneOf(banner), Tone::Bad);
    snapshot.events.clear();
    banner.showSnapshot(snapshot, true);
    EXPECT_TRUE(message(banner).startsWith(QStringLiteral("The control loop ended")));
    banner.showClosed();
    banner.showSnapshot(snapshot, true);
    EXPECT_EQ(message(banner), "Connection lost - reconnecting");
}

TEST(Banner, TellsWhyTheLogIsNotCompleteInTheLanguageOfTheWindow) {
    Banner banner;
    banner.showLogFailure(LogFailure{12, {}});
    EXPECT_EQ(message(banner), "The log is not complete: 12 rows were lost");
    Snapshot snapshot;
    snapshot.link = LinkState::Lost;
    snapshot.events.push_back({EventCode::LinkLost, PortFailure{PortFailure::Kind::Gone, {}, {}}});
    LanguageSwitch language;
    ASSERT_TRUE(language.choose(QStringLiteral("zh_CN")));
    QCoreApplication::sendPostedEvents();
    const auto shown = [&banner] { return spokenText(banner, Banner::tr("Message")); };
    const QRegularExpression english(QStringLiteral("[A-Za-z]"));
    EXPECT_TRUE(shown().contains(QStringLiteral("12")));
    EXPECT_FALSE(shown().contains(english)) << shown().toStdString();
    banner.showSnapshot(snapshot, true);
    EXPECT_FALSE(shown().contains(english)) << shown().toStdString();
    ASSERT_TRUE(language.choose(QStringLiteral("en")));
    QCoreApplication::sendPostedEvents();
    EXPECT_EQ(message(banner), "Connection lost: the port is gone - reconnecting");
}

TEST(Banner, ShowsTheTrainingAndLetsItBeCancelled) {
    Banner banner;
    banner.showTraining(0.5);
    auto* progress = qobject_cast<QProgressBar*>(findByName(banner, QStringLiteral("Training progress")));
    ASSERT_NE(progress, nullptr);
    EXPECT_EQ(progress->value() * 2, progress->maximum());
    EXPECT_FALSE(progress->isHidden());
    banner.endTraining({});
    EXPECT_TRUE(banner.isHidden());
}

} // namespace
} // namespace hexapose
