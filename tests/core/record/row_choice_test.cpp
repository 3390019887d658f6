// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/row_choice.h"
#include "tests/core/record/record_fixture.h"

#include <gmock/gmock.h>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing::Each;
using testing::Le;

/// A machine that measures every millisecond, and stands still unless a test changes it.
class RowChoiceTest : public testing::Test {
protected:
    RowChoiceTest() {
        s = fullSnapshot();
        s.state = RunState::Enabled;
    }
    /// The next cycles; how many rows come of them.
    std::size_t pass(std::chrono::milliseconds duration) {
        std::size_t rows = 0;
        for (const auto end = s.time + duration; s.time < end; s.time += 1ms) {
            for (const auto& row : choice.add(std::make_shared<const Snapshot>(s))) {
                ++rows;
                times.push_back(row->time);
            }
            s.events.clear();
        }
        return rows;
    }
    std::size_t pass1() { return pass(1ms); }
    /// Until nothing has happened for long.
    void rest() {
        pass(3000ms);
        times.clear();
    }
    std::vector<std::chrono::nanoseconds> gaps() const {
        std::vector<std::chrono::nanoseconds> result;
        for (std::size_t i = 1; i < times.size(); ++i)
            result.push_back(times[i] - times[i - 1]);
        return result;
    }

    Snapshot s;
    RowChoice choice;
    std::vector<std::chrono::nanoseconds> times; ///< of the rows
};

TEST_F(RowChoiceTest, TakesTenRowsASecondAtRest) {
    EXPECT_EQ(pass(1000ms), 1000U) << "for a second after the beginning";
    rest();
    EXPECT_EQ(pass(1000ms), 10U);
    EXPECT_THAT(gaps(), Each(100ms));
}

TEST_F(RowChoiceTest, TakesEveryMeasurementWhileItMovesAndForASecondAfterwards) {
    rest();
    s.state = RunState::Moving;
    EXPECT_GE(pass(500ms), 500U);
    s.state = RunState::Settling;
    EXPECT_EQ(pass(100ms), 100U);
    s.state = RunState::Enabled;
    EXPECT_EQ(pass(1000ms), 1000U);
    rest();
    EXPECT_EQ(pass(1000ms), 10U);
}

TEST_F(RowChoiceTest, KeepsEveryMeasurementSinceTheLastRowBeforeSomethingHappens) {
    rest();
    pass(150ms);
    s.state = RunState::Moving;
    pass(50ms);
    ASSERT_GE(times.size(), 100U);
    EXPECT_THAT(std::vector(times.begin() + 2, times.end()), testing::SizeIs(testing::Ge(98U)));
    const auto all = gaps();
    EXPECT_THAT(std::vector(all.begin() + 1, all.end()), Each(1ms)) << "none missing, none twice, none late";
}

TEST_F(RowChoiceTest, WhateverChangesEndsTheRest) {
    const std::vector<std::pair<const char*, std::function<void()>>> changes{
        {"an event", [&] { s.events = {{EventCode::Cleared}}; }},
        {"the state", [&] { s.state = RunState::Disabled; }},
        {"a set-point", [&] { s.commandedLengths = LegLengths::Constant(0.31); }},
        {"no set-point", [&] { s.commandedLengths.reset(); }},
        {"the solution", [&] { s.status = SolveStatus::Singular; }},
        {"the link", [&] { s.link = LinkState::ListenOnly; }},
        {"the controller's state", [&] { s.controllerState = ControllerState::Fault; }},
        {"the speed override", [&] { s.speed = 0.5; }},
        {"the mode", [&] { s.mode = MotionMode::Workspace; }},
        {"a hold", [&] { s.held = true; }},
        {"a leg that is pushed", [&] { (*s.measuredLengths)[4] += 0.001; }},
    };
    for (const auto& [what, change] : changes) {
        rest();
        pass(50ms);
        change();
        times.clear();
        pass1();
        ASSERT_FALSE(times.empty()) << what;
        EXPECT_EQ(pass(999ms), 999U) << what;
    }
}

TEST_F(RowChoiceTest, LegsThatFlickerByAStepOfTheirResolutionAreAtRest) {
    rest();
    std::size_t rows = 0;
    for (int i = 0; i < 1000; ++i) {
        (*s.measuredLengths)[1] = i % 3 == 0 ? 0.3366 : 0.3365;
        rows += pass1();
    }
    EXPECT_EQ(rows, 10U);
}

TEST_F(RowChoiceTest, LegsThatCreepAreLoggedWhereverTheyGo) {
    rest();
    const double begin = (*s.measuredLengths)[0];
    std::size_t rows = 0;
    for (int i = 0; i < 4000; ++i) { // a millimetre in 4 s, as in referencing by hand
        (*s.measuredLengths)[0] = begin + 0.25e-6 * i;
        rows += pass1();
    }
    EXPECT_GT(rows, 3000U);
}

TEST_F(RowChoiceTest, AtRestARowHasAMeasurementWhereTheyAreRare) {
    rest();
    std::size_t fresh = 0, rows = 0;
    for (int i = 0; i < 300; ++i) { // every third cycle of 15 ms has one
        s.fresh = i % 3 == 0;
        for (const auto& row : choice.add(std::make_shared<const Snapshot>(s))) {
            ++rows;
            fresh += row->fresh ? 1U : 0U;
        }
        s.time += 15ms;
    }
    EXPECT_EQ(fresh, rows);
    EXPECT_GE(rows, 30U);
}

TEST_F(RowChoiceTest, WithoutMeasurementsTenRowsASecondGoOn) {
    rest();
    s.fresh = false;
    s.stale = true;
    pass(3000ms);
    times.clear();
    EXPECT_EQ(pass(1000ms), 10U);
    EXPECT_THAT(gaps(), Each(Le(100ms)));
}

} // namespace
} // namespace hexapose
