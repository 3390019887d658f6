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
    const auto found = loadNamedPoses(settings, "one");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].name, QStringLiteral("load, \"left\""));
    EXPECT_LT((found[0].pose.toVector() - pose.toVector()).norm(), kRoundTrip);
    EXPECT_EQ(loadNamedPoses(settings, "other").at(0).name, QStringLiteral("测试"));
    EXPECT_TRUE(loadNamedPoses(settings, "third").empty());
}

TEST(PoseBook, PassesOverEntriesThatAreNotWhole) {
    const QTemporaryDir folder;
    QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
    saveNamedPoses(settings, "one", {{QStringLiteral("a"), Pose{}}, {QStringLiteral("b"), Pose{}}});
    settings.setValue(QStringLiteral("poses/one/1/pose"), QStringList{"1", "2", "x", "0", "0", "0"});
    const auto found = loadNamedPoses(settings, "one");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].name, QStringLiteral("b"));
}

} // namespace
} // namespace hexapose
