// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/machine_state.h"
#include "tests/support/events.h"
#include "tests/support/golden_events.h"
#include "ui/common/language.h"
#include "ui/console/events/event_list.h"
#include "ui/console/events/event_text.h"
#include "ui/console/events/input_fault_text.h"

#include <QCoreApplication>

#include <QRegularExpression>
#include <gtest/gtest.h>

#include <new>

namespace hexapose {
namespace {

const EventList::Time kNow = std::chrono::system_clock::now();

TEST(EventList, NewestIsFirstAndRepetitionsAreCounted) {
    EventList list;
    list.add(eventFrom("connected bench"), kNow);
    for (int i = 0; i < 12; ++i) {
        list.add({EventCode::ClockWentBack}, kNow);
    }
    EXPECT_EQ(list.count(), 2);
    EXPECT_TRUE(list.textAt(0).contains(QString::fromUtf8("\u00d7") + QStringLiteral("12")));
    EXPECT_TRUE(list.textAt(1).contains(QStringLiteral("Connected: bench")));
    list.add(eventFrom("move-refused leg 3 above max_mm"), kNow);
    EXPECT_TRUE(list.textAt(0).contains(QStringLiteral("Leg 3 would be above its maximum")));
    for (int i = 0; i < 1000; ++i) {
        list.add({EventCode::ControllerFault, DeviceText{std::to_string(i)}}, kNow);
    }
    EXPECT_LE(list.count(), 500);
    EXPECT_TRUE(list.textAt(0).contains(QStringLiteral("999")));
}

/// Words of our own that may stand in a text of any language: names, commands of the system, symbols.
bool isNoEnglish(const QString& word) {
    static const QStringList names{
        QStringLiteral("rig"), QStringLiteral("mm"), QStringLiteral("s"), QStringLiteral("ms"),
        QStringLiteral("FSI"), QStringLiteral("MPR3"), QStringLiteral("NR"), QStringLiteral("dev"),
        QStringLiteral("ttyX"), QStringLiteral("sudo"), QStringLiteral("usermod"), QStringLiteral("aG"),
        QStringLiteral("dialout"), QStringLiteral("USER"), QStringLiteral("q"), QStringLiteral("x"),
        QStringLiteral("EIO"), QStringLiteral("GB"), QStringLiteral("run"), QStringLiteral("csv"),
        // What a controller says, its codes among it, is shown as it is.
        QStringLiteral("STATE"), QStringLiteral("RANGE"), QStringLiteral("FORMAT"), QStringLiteral("leg")};
    static const QRegularExpression foreign(QStringLiteral("^X\\d?$"));
    return names.contains(word) || foreign.match(word).hasMatch();
}

QStringList wordsOf(const QString& text) {
    static const QRegularExpression word(QStringLiteral("[A-Za-z]+\\d?"));
    QStringList words;
    for (auto match = word.globalMatch(text); match.hasNext();) {
        words << match.next().captured();
    }
    return words;
}

TEST(EventList, EveryEventIsReportedAndTroubleSaysWhatToDo) {
    for (const GoldenEvent& golden : kGoldenEvents) {
        SCOPED_TRACE(golden.words);
        const EventText text = eventText(golden.event);
        EXPECT_FALSE(text.cause.isEmpty());
        EXPECT_NE(text.cause.section(QLatin1Char(':'), 0, 0).toStdString(), toWord(golden.event.code));
        if (text.tone == Tone::Bad || text.tone == Tone::Warn) {
            EXPECT_FALSE(text.advice.isEmpty());
        }
    }
    EXPECT_EQ(eventText(eventFrom("command-refused resume in enabled")).advice,
              "There is nothing to resume.");
    EXPECT_TRUE(
        eventText(eventFrom("command-refused run in stopped")).cause.endsWith(QStringLiteral("Stopped")));
    EXPECT_TRUE(eventText(eventFrom("stopped-on-solver no-solution"))
                    .cause.endsWith(QStringLiteral("No pose of these lengths was found")));
    EXPECT_EQ(eventText(eventFrom("stopped-on-following-error leg 3 off by 25.1 mm, limit 24.0 mm")).cause,
              QStringLiteral(
                  "Stopped: a leg does not follow: leg 3 is 25.10 mm from its set-point, more than 24.0 mm"));
    EXPECT_EQ(eventText(eventFrom("stopped-on-limits leg 3 above max_mm")).cause,
              QStringLiteral("Stopped at a limit: Leg 3 would be above its maximum"));
    EXPECT_EQ(eventText(eventFrom("stopped-on-limits near singular")).cause,
              QStringLiteral("Stopped at a limit: Too close to a singular pose"));
    EXPECT_EQ(eventText(eventFrom("stopped-on-limits across the singular poses")).cause,
              QStringLiteral("Stopped at a limit: Beyond the singular poses"));
}

/// Of the machine table's word, not of a copy of it: what is allowed comes with the refusal.
TEST(EventList, TheAdviceOfARefusalFollowsWhatIsAllowed) {
    const auto advice = [](Command command, const MachineState& machine) {
        return eventText({EventCode::CommandRefused,
                          CommandRefusal{command, machine.run, allowedCommands(machine)}})
            .advice;
    };
    const QString clear = QStringLiteral("After a stop or a fault press Clear first.");
    const QString wait = QStringLiteral("Wait until the motion is over, or press Stop.");
    const MachineState stopped{.run = RunState::Stopped, .latch = Latch::Host};
    const MachineState moving{.run = RunState::Moving, .hasControl = true};
    EXPECT_EQ(advice(Command::Run, stopped), clear);
    EXPECT_EQ(advice(Command::Jog, stopped), clear);
    EXPECT_EQ(advice(Command::Run, moving), wait);
    EXPECT_EQ(advice(Command::Run, {.run = RunState::Enabled, .pending = Pending::Motion}), wait)
        << "a motion is being prepared";
    EXPECT_EQ(advice(Command::Jog, moving), QStringLiteral("Wait until the motion is over."));
    for (const RunState off : {RunState::Unreferenced, RunState::Disabled, RunState::Enabled}) {
        EXPECT_EQ(advice(Command::Jog, {.run = off}),
                  QStringLiteral("Press Enable first; a jog does not switch the drives on."))
            << toWord(off);
    }
    EXPECT_EQ(advice(Command::Resume, moving), QStringLiteral("There is nothing to resume."));
    EXPECT_EQ(advice(Command::Clear, {.run = RunState::Enabled}), QStringLiteral("Nothing has changed."));
    EXPECT_EQ(eventText({EventCode::CommandRefused,
                         CommandRefusal{Command::Run, RunState::Disconnected, CommandSet{Command::Stop}}})
                  .advice,
              QStringLiteral("Wait until a controller is connected."));
    EXPECT_EQ(eventText(eventFrom("command-refused run in stopped")).advice,
              QStringLiteral("Nothing has changed."))
        << "a log does not tell what was allowed";
}

TEST(EventList, NoEventSpeaksEnglishInChinese) {
    LanguageSwitch language;
    ASSERT_TRUE(language.choose(QStringLiteral("zh_CN")));
    for (const GoldenEvent& golden : kGoldenEvents) {
        SCOPED_TRACE(golden.words);
        // As the loop raises it, and as a log gives it back.
        for (const Event& event : {golden.event, eventFrom(golden.words)}) {
            const EventText text = eventText(event);
            for (const QString& word : wordsOf(text.cause + QLatin1Char(' ') + text.advice)) {
                EXPECT_TRUE(isNoEnglish(word)) << word.toStdString() << " in " << text.cause.toStdString();
            }
        }
    }
    ASSERT_TRUE(language.choose(QStringLiteral("en")));
}

TEST(EventList, WhatEndsTheLoopAndWhatIsWrongWithAFileIsToldInChinese) {
    LanguageSwitch language;
    ASSERT_TRUE(language.choose(QStringLiteral("zh_CN")));
    const QString memory = eventText({EventCode::LoopFailed, DeviceText{std::bad_alloc().what()}}).cause;
    EXPECT_TRUE(wordsOf(memory).isEmpty()) << memory.toStdString();
    for (int kind = 0; kind <= static_cast<int>(InputFault::Kind::NoPoses); ++kind) {
        const InputError error(InputFault{static_cast<InputFault::Kind>(kind), "x", 3, {"x", "x"}});
        const QString text = inputFaultText(error);
        QStringList words = wordsOf(text);
        words.removeAll(QStringLiteral("x"));
        words.removeAll(QStringLiteral("UTF"));
        EXPECT_TRUE(words.isEmpty()) << text.toStdString();
        EXPECT_GT(text.size(), 8) << kind;
    }
    ASSERT_TRUE(language.choose(QStringLiteral("en")));
    EXPECT_EQ(inputFaultText(InputError("somewhere", "is only words")), "somewhere: is only words");
}

TEST(EventList, OldEntriesChangeTheirLanguageToo) {
    EventList list;
    list.add({EventCode::Referencing}, kNow);
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
