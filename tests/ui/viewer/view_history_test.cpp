// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/view_history.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using Step = ViewHistory::Step;
using std::chrono::milliseconds;

PageView view(double begin, double end) {
    return {{begin, end}, {}, false};
}

class ViewHistoryTest : public ::testing::Test {
protected:
    void show(const PageView& shown, Step step, int afterMs) {
        m_now += milliseconds(afterMs);
        history.show(shown, step, m_now);
    }
    ViewHistory history;

private:
    ViewHistory::Time m_now{};
};

TEST_F(ViewHistoryTest, GoesBackAndForward) {
    show(view(0, 5), Step::Single, 10);
    show(view(1, 2), Step::Single, 10);
    history.goBack();
    EXPECT_EQ(history.view(), view(0, 5));
    history.goForward();
    EXPECT_EQ(history.view(), view(1, 2));
    EXPECT_FALSE(history.canGoForward());
    history.goForward();
    EXPECT_EQ(history.view(), view(1, 2));
}

TEST_F(ViewHistoryTest, ABurstOfTheWheelIsOneEntry) {
    show(view(0, 5), Step::Single, 10);
    for (int i = 1; i <= 20; ++i)
        show(view(0, 5.0 - 0.1 * i), Step::Burst, 50);
    history.goBack();
    EXPECT_EQ(history.view(), view(0, 5));
}

TEST_F(ViewHistoryTest, AfterAPauseTheWheelBeginsAnotherEntry) {
    show(view(0, 5), Step::Burst, 10);
    show(view(0, 4), Step::Burst, 5000);
    history.goBack();
    EXPECT_EQ(history.view(), view(0, 5));
}

TEST_F(ViewHistoryTest, AnotherViewDropsWhatLiesForward) {
    show(view(0, 5), Step::Single, 10);
    show(view(0, 4), Step::Single, 10);
    history.goBack();
    show(view(0, 3), Step::Single, 10);
    EXPECT_FALSE(history.canGoForward());
    history.goBack();
    EXPECT_EQ(history.view(), view(0, 5));
}

TEST_F(ViewHistoryTest, TheSameViewAgainIsNoEntry) {
    show(view(0, 5), Step::Single, 10);
    show(view(0, 5), Step::Single, 10);
    history.goBack();
    EXPECT_FALSE(history.canGoBack());
}

} // namespace
} // namespace hexapose
