// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/thread_priority.h"

#include <linux/capability.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace hexapose {

namespace {

/// Above every ordinary thread and below the interrupt threads of the kernel (50).
constexpr int kRealTimePriority = 10;
constexpr int kRaisedNice = -10;
constexpr int kLoweredNice = 10;

int niceOfThisThread() {
    errno = 0;
    return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
}

void setNice(int value) {
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), value);
}

ThreadPriority currentPriority() {
    int policy = SCHED_OTHER;
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &policy, &parameters);
    switch (policy) {
    case SCHED_FIFO:
        return {ThreadPriority::Policy::Fifo, parameters.sched_priority, false};
    case SCHED_RR:
        return {ThreadPriority::Policy::RoundRobin, parameters.sched_priority, false};
    case SCHED_OTHER:
        return {ThreadPriority::Policy::Ordinary, niceOfThisThread(), false};
    default:
        return {ThreadPriority::Policy::Other, niceOfThisThread(), false};
    }
}

void leaveRealTime() {
    if (!currentPriority().isRealTime())
        return;
    const sched_param ordinary{0};
    pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary);
}

/// With a limit on locked memory, locking what comes in the future would let a later allocation fail.
bool mayLockEverything() {
    rlimit limit{};
    if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY)
        return true;
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> data{};
    return syscall(SYS_capget, &header, data.data()) == 0 && (data[0].effective & (1U << CAP_IPC_LOCK)) != 0;
}

} // namespace

ThreadPriority raiseThreadPriority() {
    ThreadPriority present = currentPriority();
    if (present.policy != ThreadPriority::Policy::Ordinary) {
        present.inherited = true;
        return present;
    }
    const sched_param wanted{kRealTimePriority};
    if (pthread_setschedparam(pthread_self(), SCHED_RR, &wanted) != 0 && present.level > kRaisedNice)
        setNice(kRaisedNice);
    return currentPriority();
}

void resetThreadPriority() {
    leaveRealTime();
    if (niceOfThisThread() < 0)
        setNice(0);
}

void lowerThreadPriority() {
    leaveRealTime();
    setNice(kLoweredNice);
}

bool lockMemory() {
    // On fault: a thread's stack is not filled with pages that it never uses.
    return mayLockEverything() && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

} // namespace hexapose
