// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A policy that the system's administrator gives the program reaches the thread that needs it.
#include "tests/app/run_bench.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <pthread.h>
#include <sched.h>
#include <thread>

namespace hexapose::apptest {
namespace {

namespace fs = std::filesystem;

struct Schedule {
    int policy = -1;
    int priority = 0;
    bool operator==(const Schedule&) const = default;
    friend void PrintTo(const Schedule& schedule, std::ostream* out) {
        *out << "policy " << schedule.policy << " priority " << schedule.priority;
    }
};

/// Of the program's thread of this name; nothing when it has none.
std::optional<Schedule> scheduleOf(pid_t process, const std::string& threadName) {
    std::error_code gone;
    for (const auto& task : fs::directory_iterator("/proc/" + std::to_string(process) + "/task", gone)) {
        if (readText(task.path() / "comm") != threadName + "\n")
            continue;
        const pid_t thread = std::stoi(task.path().filename().string());
        sched_param parameters{};
        sched_getparam(thread, &parameters);
        return Schedule{sched_getscheduler(thread), parameters.sched_priority};
    }
    return std::nullopt;
}

constexpr Schedule kGiven{SCHED_FIFO, 2};

/// The program, started with that policy as by chrt; nothing where it is not permitted.
std::unique_ptr<Process> startedWith(const Schedule& given, const std::vector<std::string>& words) {
    std::unique_ptr<Process> program;
    std::jthread([&] { // the program inherits it from the thread that starts it
        const sched_param parameters{given.priority};
        if (pthread_setschedparam(pthread_self(), given.policy, &parameters) == 0)
            program = std::make_unique<Process>(words);
    })
        .join();
    return program;
}

/// False where the policy is not permitted.
bool expectLoopKeepsPolicy(const std::vector<std::string>& words, ForeignController& controller) {
    const std::unique_ptr<Process> program = startedWith(kGiven, words);
    if (!program)
        return false;
    EXPECT_TRUE(controller.waitFor([&] { return !controller.payloads("SET").empty(); }));
    EXPECT_EQ(scheduleOf(program->pid(), "control loop"), kGiven);
    program->signal(SIGTERM);
    program->wait();
    return true;
}

TEST(RealTime, TheLoopKeepsThePolicyThatTheProgramWasStartedWith) {
    Bench bench(asTheyAre({}));
    if (!expectLoopKeepsPolicy(cliWords(bench.words()), bench.controller))
        GTEST_SKIP() << "SCHED_FIFO is not permitted here";
#ifdef HEXAPOSE_CONSOLE
    const Scratch scratch;
    ForeignController controller(scratch.path("port"), asTheyAre({}), {});
    expectLoopKeepsPolicy({HEXAPOSE_CONSOLE, "--headless", "--method", "newton", "--log-dir",
                           scratch.path("logs"), "--port", scratch.path("port")},
                          controller);
#endif
}

} // namespace
} // namespace hexapose::apptest
