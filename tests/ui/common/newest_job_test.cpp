// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/newest_job.h"

#include <QTest>
#include <QThread>

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <vector>

namespace hexapose {
namespace {

class NewestJobTest : public ::testing::Test {
protected:
    /// Work that lasts until it is cancelled.
    void startEndless() {
        std::promise<void> begun;
        job.start(
            [&begun](const Job& self) {
                begun.set_value();
                while (!self.isCancelled()) {
                    QThread::yieldCurrentThread();
                }
                return 0;
            },
            done);
        begun.get_future().wait();
    }
    void start(int number) {
        job.start(
            [this, number](const Job&) {
                ++worked;
                return number;
            },
            done);
    }
    bool isOver() {
        return QTest::qWaitFor([this] { return !job.isRunning(); });
    }

    std::vector<int> delivered;
    std::function<void(const Job::Outcome<int>&)> done = [this](const Job::Outcome<int>& outcome) {
        delivered.push_back(outcome.result.value_or(-1));
    };
    std::atomic<int> worked{0};
    NewestJob job{QStringLiteral("work")};
};

/// None of the starts waits: the first work ends only because it is cancelled.
TEST_F(NewestJobTest, TheNewestReplacesWhatRunsAndWhatWaits) {
    startEndless();
    start(1);
    start(2);
    start(3);
    EXPECT_TRUE(job.isRunning());
    EXPECT_TRUE(delivered.empty());
    ASSERT_TRUE(isOver());
    EXPECT_EQ(delivered, std::vector<int>{3});
    EXPECT_EQ(worked, 1) << "those that were replaced while they waited never began";
    start(4);
    ASSERT_TRUE(isOver());
    EXPECT_EQ(delivered, (std::vector<int>{3, 4}));
}

TEST_F(NewestJobTest, WhatIsCancelledDeliversNothing) {
    startEndless();
    start(1);
    job.cancel();
    EXPECT_FALSE(job.isRunning());
    QTest::qWait(0);
    start(2);
    ASSERT_TRUE(isOver());
    EXPECT_EQ(delivered, std::vector<int>{2});
}

TEST_F(NewestJobTest, ItsOutcomeMayStartTheNext) {
    job.start([](const Job&) { return 1; },
              [this](const Job::Outcome<int>& outcome) {
                  done(outcome);
                  start(2);
              });
    ASSERT_TRUE(QTest::qWaitFor([this] { return delivered.size() == 2; }));
    EXPECT_EQ(delivered, (std::vector<int>{1, 2}));
}

TEST_F(NewestJobTest, AnExceptionIsAnOutcomeToo) {
    job.start([](const Job&) -> int { throw std::runtime_error("no space"); }, done);
    ASSERT_TRUE(isOver());
    EXPECT_EQ(delivered, std::vector<int>{-1});
}

} // namespace
} // namespace hexapose
