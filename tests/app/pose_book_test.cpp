// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/pose_book.h"
#include "core/base/units.h"

#include <QSettings>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

constexpr double kRoundTrip = 1e-15; ///< m, rad: mm and degrees there and back

TEST(PoseBook, KeepsPosesForEachMachineApart) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("settings.ini"));
    const Pose pose{{0.012, -0.004, 0.0403}, {0.0, 0.0, radiansFromDeg(5.0)}};
    {
        QSettings settings(file, QSettings::IniFormat);
        saveNamedPoses(settings, "one",
                       {{QStringLiteral("load, \"left\""), pose}, {QStringLiteral("b"), Pose{}}});
        saveNamedPoses(settings, "other", {{QStringLiteral("测试"), Pose{}}});
        saveNamedPoses(settings, "one", {{QStringLiteral("load, \"left\""), pose}});
    }
    QSettings settings(file, QSettings::IniFormat);
    const LoadedPoses loaded = loadNamedPoses(settings, "one");
    const std::vector<NamedPose>& found = loaded.poses;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].name, QStringLiteral("load, \"left\""));
    EXPECT_LT((found[0].pose.toVector() - pose.toVector()).norm(), kRoundTrip);
    EXPECT_EQ(loadNamedPoses(settings, "other").poses.at(0).name, QStringLiteral("测试"));
    EXPECT_EQ(loaded.dropped, 0);
    EXPECT_TRUE(loadNamedPoses(settings, "third").poses.empty());
    EXPECT_EQ(loadNamedPoses(settings, "third").dropped, 0);
}

TEST(PoseBook, PassesOverEntriesThatAreNotWhole) {
    const QTemporaryDir folder;
    QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
    saveNamedPoses(settings, "one", {{QStringLiteral("a"), Pose{}}, {QStringLiteral("b"), Pose{}}});
    settings.setValue(QStringLiteral("poses/one/1/pose"), QStringList{"1", "2", "x", "0", "0", "0"});
    const LoadedPoses loaded = loadNamedPoses(settings, "one");
    const std::vector<NamedPose>& found = loaded.poses;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].name, QStringLiteral("b"));
    EXPECT_EQ(loaded.dropped, 1);
}

/// 2000000000 once kept the console from its start for minutes.
TEST(PoseBook, ASizeThatIsWrongDelaysAndLosesNothing) {
    const QTemporaryDir folder;
    QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
    std::vector<NamedPose> twelve;
    for (int k = 0; k < 12; ++k) {
        twelve.push_back({QString::number(k), Pose{}});
    }
    saveNamedPoses(settings, "one", twelve);
    for (const char* size : {"2000000000", "99999999999999", "3", "-3", "many", ""}) {
        settings.setValue(QStringLiteral("poses/one/size"), QString::fromLatin1(size));
        const LoadedPoses loaded = loadNamedPoses(settings, "one");
        ASSERT_EQ(loaded.poses.size(), 12U) << size;
        EXPECT_EQ(loaded.poses[10].name, QStringLiteral("10")) << "in their order";
        EXPECT_EQ(loaded.dropped, 0) << size;
    }
}

} // namespace
} // namespace hexapose
