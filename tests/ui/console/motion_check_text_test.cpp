// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/events/motion_check_text.h"

#include "core/record/motion_check_words.h"
#include "ui/common/status_text.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

TEST(MotionCheckText, NamesLegLimitAndExcess) {
    const MotionCheck above{MotionCheck::Reason::LegAboveMax, 3, 0.3612, 0.350, 1.0};
    EXPECT_EQ(motionCheckText(above), "Leg 3 would be 361.2 mm, above its maximum 350 mm (by 11.2 mm)");
    const MotionCheck below{MotionCheck::Reason::LegBelowMin, 2, 0.24999, 0.250, 1.0};
    EXPECT_EQ(motionCheckText(below), "Leg 2 would be 249.9900 mm, below its minimum 250 mm (by 0.0100 mm)");
    const MotionCheck path{MotionCheck::Reason::PathNearSingular, 0, 0.01, 0.05, 0.63};
    EXPECT_TRUE(motionCheckText(path).contains(QStringLiteral("63 %")));
    MotionCheck outside{MotionCheck::Reason::OutsideEnvelope, 0, 0.2, 0.1, 1.0, 5};
    EXPECT_TRUE(motionCheckText(outside).startsWith(coordinateTexts()[4].symbol))
        << motionCheckText(outside).toStdString();
    const MotionCheck fast{MotionCheck::Reason::LegSpeed, 4, 0.09, 0.08, 0.12};
    EXPECT_EQ(motionCheckText(fast),
              "Leg 4 would move at 90.0 mm/s, above its limit of 80.0 mm/s, at 12 % of the path");
    const MotionCheck aboveOnTheWay{MotionCheck::Reason::LegAboveMax, 3, 0.3612, 0.350, 0.3};
    EXPECT_EQ(motionCheckText(*motionCheckFromWords(toWords(aboveOnTheWay))),
              "Leg 3 would be above its maximum, at 30 % of the path");
    for (const MotionCheck& check :
         {above, below, path, outside, fast,
          MotionCheck{MotionCheck::Reason::LegAcceleration, 4, 1.2, 1.0, 0.12},
          MotionCheck{MotionCheck::Reason::WrongSideOfSingularity, 0, -0.1, 0.02, 0.5},
          MotionCheck{MotionCheck::Reason::NearSingular, 0, 0.01, 0.05, 1.0},
          MotionCheck{MotionCheck::Reason::OtherAssemblyMode, 0, 0, 0, 1.0},
          MotionCheck{MotionCheck::Reason::NotFinite, 0, 0, 0, 1.0}}) {
        // A log tells the reason without its numbers.
        const QString text = motionCheckText(*motionCheckFromWords(toWords(check)));
        EXPECT_FALSE(text.isEmpty());
        EXPECT_FALSE(text.contains(QStringLiteral("nan"))) << text.toStdString();
    }
}

} // namespace
} // namespace hexapose
