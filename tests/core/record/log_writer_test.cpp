// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/input_error.h"
#include "core/record/log_columns.h"
#include "core/record/log_reader.h"
#include "core/record/log_writer.h"
#include "tests/core/record/record_fixture.h"
#include "tests/support/events.h"

#include <gmock/gmock.h>

#include <sys/resource.h>
#include <sys/wait.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <ctime>
#include <mutex>
#include <thread>

namespace hexapose {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Runs in a process of its own, where limits and signals hurt nobody else.
template <typename Work>
pid_t inChild(Work work) {
    const pid_t child = fork();
    if (child == 0) {
        work();
        _exit(0);
    }
    return child;
}

class LogWriterTest : public testing::Test {
protected:
    const ScratchDirectory scratch;
    const std::filesystem::path file = scratch / "run.csv";
    const LogMetadata metadata = sampleMetadata();
};

TEST_F(LogWriterTest, ChoosesTheRowsByItself) {
    LogWriter writer(file, metadata);
    Snapshot s = fullSnapshot();
    const auto rowsAfter = [&](int milliseconds, bool fresh, RunState state, bool event) {
        s.time = std::chrono::milliseconds(milliseconds);
        s.fresh = fresh;
        s.state = state;
        s.events.clear();
        if (event)
            s.events.push_back({EventCode::Cleared});
        writer.append(s);
        return writer.rowCount();
    };
    EXPECT_EQ(rowsAfter(0, false, RunState::Disconnected, false), 1U) << "the first cycle";
    EXPECT_EQ(rowsAfter(10, false, RunState::Disconnected, false), 1U);
    EXPECT_EQ(rowsAfter(20, true, RunState::Disconnected, false), 2U) << "a measurement";
    EXPECT_EQ(rowsAfter(30, false, RunState::Enabled, false), 3U) << "a change of state";
    EXPECT_EQ(rowsAfter(40, false, RunState::Enabled, true), 4U) << "an event";
    EXPECT_EQ(rowsAfter(130, false, RunState::Enabled, false), 4U);
    EXPECT_EQ(rowsAfter(140, false, RunState::Enabled, false), 5U) << "100 ms without a row";
}

TEST_F(LogWriterTest, RowsReachTheFileWithoutAnotherAppend) {
    LogWriter writer(file, metadata);
    for (int i = 0; i < 3; ++i)
        writer.append(fullSnapshot(i));
    EXPECT_TRUE(comesTrue([&] { return lineCount(file) == 4; })) << "the flush must not wait for more rows";
}

/// Counts how often the promised time passes, by waits of a thread of its own: under a load it is late as the
/// writer is, so that the two can be compared where a clock says nothing.
class PromisedTime {
public:
    int passed() const { return m_passed; }

private:
    void run(const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any wake;
        std::unique_lock lock(mutex);
        for (; !stop.stop_requested(); ++m_passed)
            wake.wait_for(lock, stop, std::chrono::milliseconds(100), [] { return false; });
    }

    std::atomic<int> m_passed{0};
    std::jthread m_thread{[this](const std::stop_token& stop) { run(stop); }};
};

TEST_F(LogWriterTest, EveryRowReachesTheFileInThePromisedTime) {
    constexpr int kRows = 6;
    constexpr int kSlack = 4; // times the promise, on the average
    LogWriter writer(file, metadata);
    const PromisedTime time;
    for (int i = 0; i < kRows; ++i) {
        writer.append(fullSnapshot(i));
        ASSERT_TRUE(comesTrue([&] { return lineCount(file) == static_cast<std::size_t>(i) + 2; }));
    }
    EXPECT_LE(time.passed(), kSlack * kRows);
}

TEST_F(LogWriterTest, AKilledProgramLeavesWholeRows) {
    constexpr int kRows = 500;
    const pid_t child = inChild([&] {
        LogWriter writer(file, metadata);
        for (int i = 0; i < kRows; ++i)
            writer.append(fullSnapshot(i));
        for (;;)
            pause(); // no destructor, no further append: only the writer's own clock can save the rows
    });
    ASSERT_GT(child, 0);
    const bool allThere = comesTrue([&] { return lineCount(file) == kRows + 1; });
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(allThere) << lineCount(file) << " lines";
    ASSERT_TRUE(WIFSIGNALED(status));
    const SessionLog log = readSessionLog(file);
    EXPECT_THAT(log.warnings, testing::IsEmpty());
    ASSERT_EQ(log.rows.size(), static_cast<std::size_t>(kRows));
    EXPECT_EQ(log.rows.back().time, fullSnapshot(kRows - 1).time);
    EXPECT_TRUE(log.platform.has_value());
}

TEST_F(LogWriterTest, AProgramKilledInTheMiddleLeavesAPrefix) {
    constexpr std::uintmax_t kWaiting = 300000; // bytes: less than the queue holds
    const auto size = [&] {
        std::error_code absent;
        const std::uintmax_t bytes = std::filesystem::file_size(file, absent);
        return absent ? 0 : bytes;
    };
    const pid_t child = inChild([&] {
        LogWriter writer(file, metadata);
        std::uintmax_t sent = 0;
        for (int i = 0;; ++i) {
            std::string row;
            appendLogRow(fullSnapshot(i), row);
            sent += row.size();
            writer.append(fullSnapshot(i));
            comesTrue([&] { return size() + kWaiting > sent; });
        }
    });
    ASSERT_GT(child, 0);
    const bool underWay = comesTrue([&] { return size() > 2 * kWaiting; });
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    ASSERT_TRUE(underWay);
    const SessionLog log = readSessionLog(file);
    EXPECT_LE(log.warnings.size(), 1U) << "at most the last line is torn";
    ASSERT_GE(log.rows.size(), 1000U);
    for (std::size_t i = 0; i < log.rows.size(); ++i)
        ASSERT_EQ(log.rows[i].time, fullSnapshot(static_cast<int>(i)).time);
}

/// In a child whose files may not grow past a limit: the same as a full disk, as far as write() tells.
void fillTheDisk(const std::filesystem::path& file, const LogMetadata& metadata) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit unlimited{};
    getrlimit(RLIMIT_FSIZE, &unlimited);
    rlimit small = unlimited;
    small.rlim_cur = 100000;
    int i = 0;
    std::uint64_t taken = 0;
    std::uint64_t lost = 0;
    {
        LogWriter writer(file, metadata, ofAnyDisk());
        setrlimit(RLIMIT_FSIZE, &small);
        const bool failed = comesTrue([&] {
            writer.append(fullSnapshot(i++));
            return writer.failure().has_value() && !writer.failure()->system.empty();
        });
        std::vector<Event> events;
        if (!comesTrue([&] {
                writer.takeEvents(events);
                return !events.empty();
            }) ||
            events[0].code != EventCode::LogFailed || events[0].get<LogFailure>()->system.empty())
            _exit(5);
        for (int more = 0; more < 10000; ++more)
            writer.append(fullSnapshot(i++));
        lost = writer.lostCount();
        taken = writer.rowCount();
        if (!failed || lost == 0 || taken + lost != static_cast<std::uint64_t>(i))
            _exit(1);
        setrlimit(RLIMIT_FSIZE, &unlimited);
    }
    if (lineCount(file) != taken + 1)
        _exit(2);
    const SessionLog log = readSessionLog(file);
    if (!log.warnings.empty() || log.rows.size() != taken)
        _exit(3);
    // On a busy machine the queue may have been full before the disk was, too.
    std::uint64_t told = 0;
    for (const Snapshot& row : log.rows)
        for (const Event& event : row.events)
            told += event.code == EventCode::LogFailed ? event.get<LogFailure>()->rowsLost : 0;
    if (told != lost || log.rows.back().events.empty())
        _exit(4);
}

TEST_F(LogWriterTest, AFullDiskIsToldAndGotOver) {
    const pid_t child = inChild([&] { fillTheDisk(file, metadata); });
    int status = -1;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0) << "1: failure or loss not counted, 2: rows missing, 3: torn rows, 4: "
                                         "the gap is not in the log, 5: it is not reported";
}

std::string refusal(const std::filesystem::path& file, const LogMetadata& metadata) {
    try {
        const LogWriter writer(file, metadata);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST_F(LogWriterTest, OverwritesNothing) {
    scratch.write("run.csv", "precious");
    EXPECT_THAT(refusal(file, metadata), HasSubstr("run.csv: exists already"));
    EXPECT_EQ(readAll(file), "precious");
    EXPECT_FALSE(std::filesystem::exists(scratch / "run.toml"));

    scratch.write("platform.toml", "precious too");
    EXPECT_THAT(refusal(scratch / "platform.csv", metadata), HasSubstr("platform.toml: exists already"));
    EXPECT_EQ(readAll(scratch / "platform.toml"), "precious too");
    EXPECT_FALSE(std::filesystem::exists(scratch / "platform.csv")) << "no empty log is left behind";
    EXPECT_THAT(refusal(scratch / "absent" / "run.csv", metadata),
                HasSubstr("cannot be created: No such file"));
}

TEST_F(LogWriterTest, NewNamesAreDatedAndFree) {
    const std::filesystem::path directory = scratch / "a" / "b";
    std::tm local{};
    local.tm_year = 126;
    local.tm_mon = 2;
    local.tm_mday = 1;
    local.tm_hour = 14;
    local.tm_min = 5;
    local.tm_sec = 9;
    local.tm_isdst = -1;
    const auto now = std::chrono::system_clock::from_time_t(std::mktime(&local));
    EXPECT_EQ(newLogFile(directory, now), directory / "hexapose-20260301-140509.csv");
    std::ofstream(directory / "hexapose-20260301-140509.csv") << "x";
    std::ofstream(directory / "hexapose-20260301-140509-2.toml") << "x";
    EXPECT_EQ(newLogFile(directory, now), directory / "hexapose-20260301-140509-3.csv");
    EXPECT_THROW(newLogFile(directory / "hexapose-20260301-140509.csv", now), InputError);
}

TEST_F(LogWriterTest, TheMetadataIsAPlatformFileUnderPlatform) {
    const auto start = fullSnapshot().wallTime;
    const std::string text = formatLogMetadata(metadata, start);
    EXPECT_THAT(text, HasSubstr("\nstart_time = 2026-03-01T14:05:09.250Z\n"));
    EXPECT_THAT(text, HasSubstr("\n[platform]\nformat = 1\n"));
    EXPECT_THAT(text, HasSubstr("\n[platform.home]\nposition_mm"));
    EXPECT_THAT(text, HasSubstr("\n[[platform.leg]]\nbase_mm"));
    const RecordedMetadata back = readLogMetadata(scratch.write("m.toml", text));
    EXPECT_EQ(formatPlatform(back.platform.value()), formatPlatform(metadata.platform)) << "to the last bit";
}

TEST_F(LogWriterTest, KeepsTheLastCyclesOfEveryFaultBesideTheLog) {
    constexpr int kCycles = 700, kFirstFault = 50;
    {
        LogWriter writer(file, metadata);
        Snapshot s = fullSnapshot();
        for (int k = 0; k < kCycles; ++k) {
            s.time = std::chrono::milliseconds(10 * k);
            s.fresh = false; // most of these are no rows of the log
            s.events.clear();
            if (k == kFirstFault || k == kCycles - 1)
                s.events.push_back(eventFrom("stopped-on-solver singular"));
            if (k == 60)
                s.events.push_back({EventCode::StopRequested});
            writer.append(s);
        }
    }
    EXPECT_EQ(lineCount(scratch / "run-fault-1.csv"), 1U + kFirstFault + 1U)
        << "the header, and all there was";
    EXPECT_EQ(lineCount(scratch / "run-fault-2.csv"), 1U + 500U);
    EXPECT_FALSE(std::filesystem::exists(scratch / "run-fault-3.csv"))
        << "a stop that was asked for is no fault";
    const SessionLog kept = readSessionLog(scratch / "run-fault-2.csv");
    ASSERT_EQ(kept.rows.size(), 500U);
    EXPECT_EQ(kept.rows.back().time, std::chrono::milliseconds(10 * (kCycles - 1)));
    EXPECT_EQ(kept.rows.back().events.front().code, EventCode::StoppedOnSolver);
    EXPECT_EQ(kept.rows.front().time, std::chrono::milliseconds(10 * (kCycles - 500)));
}

} // namespace
} // namespace hexapose
