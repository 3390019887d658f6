// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/event.h"
#include "core/record/log_metadata.h"
#include "core/record/log_options.h"
#include "core/record/snapshot.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hexapose {

/// Writes one CSV a session from a thread of its own, handed to the system at least every 100 ms. Opening
/// throws InputError (an existing file is never overwritten: "run.csv: exists already"); later write errors
/// do not throw, failure() and takeEvents() report them. Writing is tried again until it works; meanwhile
/// rows wait in a queue of fixed size, and those that find it full are lost and counted. The log itself
/// reports it: an event log-failed in the last row before the gap. A log that reaches the size of a part, or
/// whose file is taken away, goes on in "run-2.csv" and so on. When something ends a motion unasked (isFault)
/// the last 500 cycles, rows or not, are kept in a file of their own beside the log: "run-fault-1.csv".
class LogWriter {
public:
    LogWriter(const std::filesystem::path& csvFile, const LogMetadata& metadata, LogOptions options = {});
    ~LogWriter(); ///< as finish()
    LogWriter(const LogWriter&) = delete;
    LogWriter& operator=(const LogWriter&) = delete;

    /// Cheap, copies nothing; called by one thread. Decides by itself which cycles become rows (RowChoice).
    void append(const std::shared_ptr<const Snapshot>& snapshot);
    /// The same of a copy.
    void append(const Snapshot& snapshot) { append(std::make_shared<const Snapshot>(snapshot)); }
    /// Writes and flushes what is left; failure() then knows of all of it. Nothing is appended afterwards.
    void finish();
    /// Adds what a person should know of the log and that was not reported yet: that it cannot be written,
    /// that little space is left, in which file it goes on. Costs next to nothing while there is nothing;
    /// from any thread.
    void takeEvents(std::vector<Event>& events);
    std::uint64_t rowCount() const;  ///< rows taken, not counting lost ones
    std::uint64_t lostCount() const; ///< rows that found the queue full
    /// Why the log is not complete, or not being written at present; empty while all is well.
    std::optional<LogFailure> failure() const;
    std::filesystem::path file() const; ///< the part that is being written, or was last

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// dir/hexapose-YYYYMMDD-HHMMSS.csv in local time, with -2, -3 ... when taken. Creates the directory; throws
/// InputError when that fails.
std::filesystem::path newLogFile(const std::filesystem::path& directory,
                                 std::chrono::system_clock::time_point now);

/// Where the cycles before the log's fault of that number are kept: dir/run-fault-1.csv for dir/run.csv.
std::filesystem::path faultFile(const std::filesystem::path& csvFile, int number);

} // namespace hexapose
