// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hexapose {

/// How the system schedules a thread.
struct ThreadPriority {
    enum class Policy {
        Ordinary,   ///< shared fairly, weighted by the nice value
        Fifo,       ///< real time: runs until it waits
        RoundRobin, ///< real time: takes turns with threads of the same priority
        Other,      ///< any other policy that the process was started with
    };
    Policy policy = Policy::Ordinary;
    int level = 0;          ///< priority of a real-time policy (1 is lowest); else the nice value
    bool inherited = false; ///< set explicitly for the process (chrt, a service unit), and kept
    bool isRealTime() const { return policy == Policy::Fifo || policy == Policy::RoundRobin; }
};

/// For a thread that must not wait behind a busy desktop. A policy that the process was started with is kept;
/// otherwise a low real-time priority is asked for, and a negative nice value where that is not permitted.
/// Threads that the calling one starts later inherit what it got. Returns what the system then reports.
ThreadPriority raiseThreadPriority();

/// For a helper that a raised thread starts, and that must not compete with it: as an ordinary thread.
void resetThreadPriority();

/// For work that can wait: behind every ordinary thread, and never in real time.
void lowerThreadPriority();

/// Keeps the memory of the process, present and future, from being paged out. False where not permitted.
bool lockMemory();

} // namespace hexapose
