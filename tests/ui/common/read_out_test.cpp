// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/screen_reader.h"
#include "ui/common/read_out.h"
#include "ui/common/status_text.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace hexapose {
namespace {

using testing::spokenText;

TEST(ReadOut, ScreenReaderGetsTheValueAndNotTheName) {
    ReadOut readOut;
    readOut.setAccessibleName(QStringLiteral("Measured x"));
    EXPECT_EQ(spokenText(&readOut), "--");
    readOut.showNumber(12.0031, 3); // the application's locale writes "12,003"
    EXPECT_EQ(spokenText(&readOut), "12.003");
    readOut.showNumber(-0.00001, 3);
    EXPECT_EQ(spokenText(&readOut), "0.000");
    readOut.showNumber(std::numeric_limits<double>::quiet_NaN(), 3);
    EXPECT_EQ(spokenText(&readOut), "--");
    readOut.showNumber(1.0, 3);
    readOut.showNumber(std::nullopt, 3);
    EXPECT_EQ(spokenText(&readOut), "--");
    EXPECT_TRUE(QAccessible::queryAccessibleInterface(&readOut)->state().readOnly);
    TextReadOut sentence(3);
    sentence.showText(QStringLiteral("Reachable"));
    EXPECT_EQ(spokenText(&sentence), "Reachable");
}

TEST(ReadOut, OldValueIsSaidToBeOld) {
    ReadOut readOut;
    readOut.setStale(true);
    EXPECT_FALSE(readOut.accessibleDescription().isEmpty());
    EXPECT_TRUE(readOut.property("stale").toBool());
    readOut.setStale(false);
    EXPECT_TRUE(readOut.accessibleDescription().isEmpty());
}

TEST(StatusText, EveryStateAndStatusHasWordsOfItsOwn) {
    QStringList seen;
    for (const RunState state :
         {RunState::Disconnected, RunState::Unreferenced, RunState::Disabled, RunState::Enabled,
          RunState::Moving, RunState::Settling, RunState::Stopped, RunState::Fault}) {
        seen << stateText(state);
    }
    for (const SolveStatus status :
         {SolveStatus::Converged, SolveStatus::IterationLimit, SolveStatus::Singular, SolveStatus::NoSolution,
          SolveStatus::InvalidInput, SolveStatus::OutsideModel, SolveStatus::OtherBranch}) {
        seen << solveStatusText(status);
    }
    EXPECT_EQ(seen.removeDuplicates(), 0);
    EXPECT_FALSE(seen.contains(QString()));
    EXPECT_EQ(solverTitle("mpr3-nr"), "MPR3-NR");
    EXPECT_EQ(solverTitle("of-another-maker"), "of-another-maker");
}

TEST(StatusText, ErrorsOfAnglesTakeTheShortWay) {
    constexpr double kRounding = 1e-9;
    EXPECT_NEAR(displayError(0, 0.0121, 0.012), 0.1, kRounding);
    const double almostHalfTurn = std::numbers::pi - 0.001;
    EXPECT_NEAR(displayError(5, -almostHalfTurn, almostHalfTurn), 0.002 * 180.0 / std::numbers::pi,
                kRounding);
    EXPECT_NEAR(fromDisplay(4, toDisplay(4, 0.3)), 0.3, kRounding);
}

} // namespace
} // namespace hexapose
