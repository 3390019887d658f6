// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/exit_guard.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace hexapose {
namespace {

[[noreturn]] void endAsQtDoesWithoutDisplay() {
    const ExitGuard guard([] { std::fputs("stopped and disabled", stderr); });
    std::exit(3);
}

[[noreturn]] void endAfterTheGuard() {
    {
        const ExitGuard guard([] { std::fputs("stopped and disabled", stderr); });
    }
    std::exit(4);
}

TEST(ExitGuard, ActsWhenTheProgramIsEndedUnderneathIt) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(endAsQtDoesWithoutDisplay(), testing::ExitedWithCode(3), "stopped and disabled");
}

TEST(ExitGuard, DoesNothingOnceItIsGone) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(endAfterTheGuard(), testing::ExitedWithCode(4), "^$");
}

} // namespace
} // namespace hexapose
