// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/thread_priority.h"

#include <gtest/gtest.h>

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <functional>
#include <thread>

namespace hexapose {
namespace {

int presentPolicy() {
    int policy = -1;
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &policy, &parameters);
    return policy;
}

int presentNice() {
    return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
}

/// On a thread that has this real-time policy; false where it is not permitted.
bool inRealTime(int policy, int priority, const std::function<void()>& work) {
    bool permitted = false;
    std::jthread([&] {
        const sched_param wanted{priority};
        permitted = pthread_setschedparam(pthread_self(), policy, &wanted) == 0;
        if (permitted)
            work();
    }).join();
    return permitted;
}

TEST(ThreadPriority, APolicyThatWasGivenIsKept) {
    for (const int policy : {SCHED_FIFO, SCHED_RR}) {
        const bool permitted = inRealTime(policy, 3, [policy] {
            const ThreadPriority priority = raiseThreadPriority();
            EXPECT_EQ(presentPolicy(), policy);
            EXPECT_EQ(priority.level, 3);
            EXPECT_TRUE(priority.inherited);
            EXPECT_TRUE(priority.isRealTime());
        });
        if (!permitted)
            GTEST_SKIP() << "real-time policies are not permitted here";
    }
}

TEST(ThreadPriority, WorkThatCanWaitLeavesRealTime) {
    const bool permitted = inRealTime(SCHED_FIFO, 2, [] {
        lowerThreadPriority();
        EXPECT_EQ(presentPolicy(), SCHED_OTHER);
        EXPECT_GT(presentNice(), 0);
    });
    if (!permitted)
        GTEST_SKIP() << "real-time policies are not permitted here";
}

TEST(ThreadPriority, AHelperOfARaisedThreadIsOrdinaryAgain) {
    std::jthread([] {
        raiseThreadPriority();
        std::jthread([] {
            resetThreadPriority();
            EXPECT_EQ(presentPolicy(), SCHED_OTHER);
            EXPECT_GE(presentNice(), 0);
        }).join();
    }).join();
}

TEST(ThreadPriority, RaisedItIsWhatTheSystemSaysAndThreadsInheritIt) {
    std::jthread([] {
        const ThreadPriority raised = raiseThreadPriority();
        EXPECT_EQ(raised.isRealTime(), presentPolicy() == SCHED_RR);
        if (!raised.isRealTime()) {
            EXPECT_EQ(raised.level, presentNice());
        }
        EXPECT_FALSE(raised.inherited);
        std::jthread([&] { EXPECT_EQ(raiseThreadPriority().policy, raised.policy); }).join();
    }).join();
}

TEST(ThreadPriority, LoweredItIsBehindOrdinaryThreads) {
    std::jthread([] {
        lowerThreadPriority();
        EXPECT_EQ(presentPolicy(), SCHED_OTHER);
        EXPECT_GT(presentNice(), 0);
    }).join();
}

} // namespace
} // namespace hexapose
