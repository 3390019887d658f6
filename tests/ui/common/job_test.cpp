// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/job.h"

#include <QTest>
#include <QThread>

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <vector>

namespace hexapose {
namespace {

TEST(Job, WorksOnAThreadOfItsOwnAndDeliversOnTheOwners) {
    Job job(QStringLiteral("work"));
    QThread* const here = QThread::currentThread();
    QThread* there = nullptr;
    std::vector<int> delivered;
    job.start(
        [&](const Job& self) {
            there = QThread::currentThread();
            self.deliver([&] { delivered.push_back(1); });
            return 42;
        },
        [&](const Job::Outcome<int>& outcome) {
            EXPECT_EQ(QThread::currentThread(), here);
            EXPECT_FALSE(job.isRunning());
            delivered.push_back(outcome.result.value_or(0));
        });
    EXPECT_TRUE(job.isRunning());
    ASSERT_TRUE(QTest::qWaitFor([&] { return delivered.size() == 2; }));
    EXPECT_EQ(delivered, (std::vector<int>{1, 42})) << "in the order in which they were given";
    EXPECT_NE(there, here);
}

TEST(Job, AnExceptionIsDeliveredAsItsMessage) {
    Job job(QStringLiteral("work"));
    QString error;
    job.start([](const Job&) -> int { throw std::runtime_error("no space"); },
              [&](const Job::Outcome<int>& outcome) {
                  EXPECT_FALSE(outcome.result);
                  error = outcome.error;
              });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !error.isEmpty(); }));
    EXPECT_EQ(error, "no space");
}

/// The first is at its end, its outcome under way, when the second begins.
TEST(Job, WorkThatIsReplacedDeliversNothingAnyMore) {
    Job job(QStringLiteral("work"));
    std::vector<int> delivered;
    const auto done = [&](const Job::Outcome<int>& outcome) { delivered.push_back(*outcome.result); };
    std::promise<void> begun;
    job.start(
        [&](const Job& self) {
            self.deliver([&] { delivered.push_back(0); });
            begun.set_value();
            while (!self.isCancelled()) {
                QThread::yieldCurrentThread();
            }
            return 1;
        },
        done);
    begun.get_future().wait();
    job.start([](const Job& self) { return self.isCancelled() ? -1 : 2; }, done);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !job.isRunning(); }));
    EXPECT_EQ(delivered, std::vector<int>{2});
}

TEST(Job, DeliversNothingWhenItIsGone) {
    bool delivered = false;
    std::atomic<bool> ended{false};
    {
        Job job(QStringLiteral("work"));
        job.start(
            [&](const Job& self) {
                while (!self.isCancelled()) {
                    QThread::yieldCurrentThread();
                }
                ended = true;
                return 1;
            },
            [&](const Job::Outcome<int>&) { delivered = true; });
    }
    EXPECT_TRUE(ended) << "its end is waited for";
    QCoreApplication::processEvents();
    EXPECT_FALSE(delivered);
}

TEST(Job, CanBeStartedAgainFromItsOwnOutcome) {
    Job job(QStringLiteral("work"));
    int rounds = 0;
    std::function<void(const Job::Outcome<int>&)> next = [&](const Job::Outcome<int>&) {
        if (++rounds < 5) {
            job.start([](const Job&) { return 0; }, next);
        }
    };
    job.start([](const Job&) { return 0; }, next);
    ASSERT_TRUE(QTest::qWaitFor([&] { return rounds == 5 && !job.isRunning(); }));
}

} // namespace
} // namespace hexapose
