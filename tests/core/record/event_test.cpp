// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The words of events in the log: as they were before events carried values, byte for byte.

#include "core/base/units.h"
#include "core/record/event_codec.h"
#include "tests/support/golden_events.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace hexapose {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(EventCodec, WritesTheLogOfBeforeByteForByte) {
    std::set<EventCode> seen;
    for (const auto& golden : kGoldenEvents) {
        SCOPED_TRACE(golden.words);
        const std::optional<Event> event = parseEvent(golden.words);
        ASSERT_TRUE(event);
        EXPECT_EQ(formatEvent(*event), golden.words);
        EXPECT_EQ(formatEvent(golden.event), golden.words);
        EXPECT_EQ(event->code, golden.event.code);
        EXPECT_EQ(event->data.index(), golden.event.data.index()) << "the payload is read as a value";
        seen.insert(event->code);
    }
    EXPECT_EQ(seen.size(), eventCodeCount()) << "each code is among them";
    EXPECT_EQ(toWord(static_cast<EventCode>(eventCodeCount())), "unknown");
}

TEST(EventCodec, ReadsValuesBack) {
    const Event following =
        *parseEvent("stopped-on-following-error leg 3 off the path by 5.25 mm, limit 24.0 mm");
    const auto* error = following.get<FollowingError>();
    ASSERT_NE(error, nullptr);
    EXPECT_EQ(error->cause, FollowingError::Cause::Path);
    EXPECT_EQ(error->leg, 3);
    EXPECT_NEAR(error->gap, metresFromMm(5.25), 1e-12);
    EXPECT_NEAR(error->limit, metresFromMm(24.0), 1e-12);

    const Event refused = *parseEvent("move-refused path near singular at 63 %");
    const auto* check = refused.get<MotionCheck>();
    ASSERT_NE(check, nullptr);
    EXPECT_EQ(check->reason, MotionCheck::Reason::PathNearSingular);
    EXPECT_NEAR(check->fraction, 0.63, 1e-12);
    EXPECT_TRUE(std::isnan(check->value)) << "the words do not tell it";

    EXPECT_EQ(*parseEvent("command-refused run in stopped")->get<CommandRefusal>(),
              (CommandRefusal{Command::Run, RunState::Stopped}));
    EXPECT_EQ(parseEvent("controller-refused SET RANGE leg 2")->get<DeviceRefusal>()->reason,
              RefusalReason::Range);
    EXPECT_EQ(parseEvent("controller-refused CLEAR STATE the stop is not confirmed yet")
                  ->get<DeviceRefusal>()
                  ->reason,
              RefusalReason::StopUnconfirmed);
    EXPECT_EQ(parseEvent("link-lost /dev/ttyUSB0: the port is gone")->get<PortFailure>()->kind,
              PortFailure::Kind::Gone);
}

TEST(EventCodec, KeepsWhatIsNotOfItsFormAsText) {
    for (const char* words : {"settled soon", "command-refused dance in stopped",
                              "stopped-on-following-error leg 9 off by 1 mm, limit 2 mm",
                              "jog-limited by a wall", "no-answer FOO", "stopped-by-controller X",
                              "log-failed -3 rows lost", "data-stale 250.5 no frames"}) {
        const std::optional<Event> event = parseEvent(words);
        ASSERT_TRUE(event) << words;
        EXPECT_NE(event->get<DeviceText>(), nullptr) << words;
        EXPECT_EQ(formatEvent(*event), words);
    }
    EXPECT_FALSE(parseEvent("nonsense"));
    EXPECT_FALSE(parseEvent(""));
}

TEST(EventCodec, SurvivesTheFieldOfARow) {
    EXPECT_EQ(formatEvent({EventCode::ControllerFault, DeviceText{"gone\r\naway"}}),
              "controller-fault gone  away")
        << "a row is one line whatever a controller says";
    const std::vector<Event> events{{EventCode::DataStale, 250.5},
                                    {EventCode::ControllerFault, DeviceText{"7 drive; axis 2; hot"}},
                                    {EventCode::Cleared}};
    const std::vector<Event> back = parseEvents(formatEvents(events));
    ASSERT_EQ(back.size(), events.size());
    for (std::size_t i = 0; i < back.size(); ++i)
        EXPECT_EQ(formatEvent(back[i]), formatEvent(events[i]));
    EXPECT_THAT(parseEvents("nonsense; and more"), IsEmpty());
}

} // namespace
} // namespace hexapose
