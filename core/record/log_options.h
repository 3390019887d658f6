// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>

namespace hexapose {

/// How a log is kept on the disk.
struct LogOptions {
    static constexpr std::uint64_t kPartBytes = 1'000'000'000;

    std::uint64_t partBytes = kPartBytes; ///< then the log goes on in another file
    /// Makes `to`, which does not exist, of the closed part `from`; false where it was stopped or failed, and
    /// then there is no `to`. Called on a thread of its own. Empty: parts stay as they are.
    std::function<bool(const std::filesystem::path& from, const std::filesystem::path& to,
                       const std::stop_token& stop)>
        compress;
    /// Bytes that are left for a file of this directory; nothing when that is not known. Empty: the system's
    /// answer.
    std::function<std::optional<std::uint64_t>(const std::filesystem::path& directory)> freeSpace;
    std::chrono::milliseconds watchDiskEvery{5000};
};

} // namespace hexapose
