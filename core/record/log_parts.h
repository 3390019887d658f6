// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/append_file.h"
#include "core/record/event.h"
#include "core/record/log_metadata.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace hexapose {

/// The files of one log: run.csv, run-2.csv, ..., each with the header and with its metadata beside it. Takes
/// text and keeps what the system does not take. Never overwrites a file.
class LogParts {
public:
    using Cause = LogContinuation::Cause;

    /// Throws InputError when the first part cannot be made.
    LogParts(const std::filesystem::path& csvFile, LogMetadata metadata, std::uint64_t partBytes);

    /// A whole row. Where the part would become larger than it may, the next one begins with it.
    void add(std::string_view row);
    /// Hands all that was added to the system. False while something is left; then failure() knows why.
    bool write();
    bool hasUnwritten() const { return !m_text.empty(); }
    /// Whether the file is still where it was made; if not, the log goes on in another one. Of a file that
    /// was deleted all is written again; `meanwhile` is called now and then, and may add rows.
    void checkPlace(const std::function<void()>& meanwhile);
    /// The solver of the parts that are begun from now on.
    void setSolver(const SolverChoice& solver);

    const std::filesystem::path& file() const { return m_file; }
    std::uint64_t bytesWritten() const { return m_bytesOfParts + m_bytes; } ///< of all parts
    /// The system's words; empty while all is well.
    const std::string& failure() const { return m_failure; }
    /// The parts that were begun since the last call.
    std::vector<LogContinuation> takeContinuations() { return std::exchange(m_continuations, {}); }
    /// Those that are complete, and were not taken from us.
    std::vector<std::filesystem::path> takeClosedParts() { return std::exchange(m_closedParts, {}); }

private:
    struct NewPart {
        std::filesystem::path file;
        std::unique_ptr<AppendFile> out;
    };
    NewPart makePart(int part) const;
    bool mayTryPart() const;
    bool tryPart(NewPart& next);
    bool copyAll(AppendFile& to, std::uint64_t& copied, const std::function<void()>& meanwhile);
    void goOnIn(NewPart next, Cause cause, std::uint64_t bytes);
    void startNext();

    const std::filesystem::path m_firstFile;
    const std::chrono::system_clock::time_point m_start = std::chrono::system_clock::now();
    LogMetadata m_metadata;
    const std::uint64_t m_partBytes;

    std::filesystem::path m_file;
    std::unique_ptr<AppendFile> m_out;
    std::uint64_t m_bytes = 0;        ///< of this part, with the system
    std::uint64_t m_bytesOfParts = 0; ///< of those before it
    std::string m_text;               ///< whole rows that are not, or not wholly, with the system
    bool m_isCopying = false;         ///< then no other part is begun
    std::size_t m_textDone = 0;       ///< what of it is
    std::string m_failure, m_partFailure;
    std::optional<std::chrono::steady_clock::time_point>
        m_partFailedAt; ///< then another is not tried at once
    std::vector<LogContinuation> m_continuations;
    std::vector<std::filesystem::path> m_closedParts;
};

} // namespace hexapose
