// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/record/snapshot.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace hexapose {

/// What stands beside the log, in a file of the same name with the ending .toml.
struct LogMetadata {
    PlatformGeometry platform;
    std::string modelFingerprint; ///< empty: no model
    std::string solver;           ///< method word
    std::string programVersion;
    std::string port;             ///< "virtual" or a path
};

/// Writes one CSV a session from a thread of its own, flushed at least every 100 ms. Opening throws InputError (an
/// existing file is never overwritten: "run.csv: exists already"); later write errors do not throw, they are told by
/// failure().
class LogWriter {
public:
    LogWriter(const std::filesystem::path& csvFile, const LogMetadata& metadata);
    ~LogWriter(); ///< writes and flushes what is left
    LogWriter(const LogWriter&) = delete;
    LogWriter& operator=(const LogWriter&) = delete;

    /// Cheap; called by the loop. Decides by itself which cycles become rows: every fresh measurement, every event,
    /// every change of state, and one row in 100 ms otherwise.
    void append(const Snapshot& snapshot);
    std::uint64_t rowCount() const;
    std::optional<std::string> failure() const;
    const std::filesystem::path& file() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// dir/hexapose-YYYYMMDD-HHMMSS.csv in local time, with -2, -3 ... when taken. Creates the directory; throws
/// InputError when that fails.
std::filesystem::path newLogFile(const std::filesystem::path& directory, std::chrono::system_clock::time_point now);

} // namespace hexapose
