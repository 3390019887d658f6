// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/language.h"
#include "ui/console/events/event_list.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

const EventList::Time kNow = std::chrono::system_clock::now();

TEST(EventList, NewestIsFirstAndRepetitionsAreCounted) {
    EventList list;
    list.add({EventCode::Connected, 0.0, "bench"}, kNow);
    for (int i = 0; i < 12; ++i) {
        list.add({EventCode::ClockWentBack, 0.0, {}}, kNow);
    }
    EXPECT_EQ(list.count(), 2);
    EXPECT_TRUE(list.textAt(0).contains(QString::fromUtf8("\u00d7") + QStringLiteral("12")));
    EXPECT_TRUE(list.textAt(1).contains(QStringLiteral("Connected: bench")));
    list.add({EventCode::MoveRefused, 0.0, "leg 3 above max_mm"}, kNow);
    EXPECT_TRUE(list.textAt(0).contains(QStringLiteral("Leg 3 would be above its maximum")));
    for (int i = 0; i < 1000; ++i) {
        list.add({EventCode::NoAnswer, 0.0, std::to_string(i)}, kNow);
    }
    EXPECT_LE(list.count(), 500);
    EXPECT_TRUE(list.textAt(0).contains(QStringLiteral("999")));
}

TEST(EventList, EveryEventIsSaidAndTroubleSaysWhatToDo) {
    for (int code = 0; code <= static_cast<int>(EventCode::DisableUnconfirmed); ++code) {
        const Event event{static_cast<EventCode>(code), 2.0, "detail"};
        const EventText text = eventText(event);
        EXPECT_NE(text.cause.section(QLatin1Char(':'), 0, 0).toStdString(), toWord(event.code))
            << toWord(event.code);
        if (text.tone == Tone::Bad || text.tone == Tone::Warn) {
            EXPECT_FALSE(text.advice.isEmpty()) << toWord(event.code);
        }
    }
    EXPECT_TRUE(eventText({EventCode::CommandRefused, 0.0, "run in stopped"})
                    .cause.endsWith(QStringLiteral("Stopped")));
    EXPECT_TRUE(eventText({EventCode::StoppedOnSolver, 0.0, "no-solution"})
                    .cause.endsWith(QStringLiteral("No pose of these lengths was found")));
    EXPECT_EQ(
        eventText({EventCode::StoppedOnFollowingError, 0.0, "leg 3 off by 25.1 mm, limit 24.0 mm"}).cause,
        QStringLiteral("Stopped: leg 3 is 25.1 mm from its set-point, more than 24.0 mm"));
    EXPECT_TRUE(eventText({EventCode::StoppedOnLimits, 0.0, "leg 3 above max_mm"})
                    .cause.endsWith(QStringLiteral("Leg 3 would be above its maximum")));
}

TEST(EventList, OldEntriesChangeTheirLanguageToo) {
    EventList list;
    list.add({EventCode::Referencing, 0.0, {}}, kNow);
    const QString english = list.textAt(0);
    LanguageSwitch language;
    ASSERT_TRUE(language.choose(QStringLiteral("zh_CN")));
    QCoreApplication::sendPostedEvents();
    EXPECT_NE(list.textAt(0), english);
    EXPECT_EQ(list.textAt(0).left(19), english.left(19)); // the date
    language.choose(QStringLiteral("en"));
    QCoreApplication::sendPostedEvents();
    EXPECT_EQ(list.textAt(0), english);
}

} // namespace
} // namespace hexapose
