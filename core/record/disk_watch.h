// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/event.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace hexapose {

/// Warns in time of a disk that is getting full.
class DiskWatch {
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::uint64_t kLowBytes = 2'000'000'000;
    static constexpr double kLowSeconds = 3600.0;

    /// Called now and then with what is free and what was written in all. A warning when less is left than
    /// kLowBytes, or than kLowSeconds take at the rate of the last minutes; another at each half of it.
    std::optional<LogSpace> update(Time now, std::uint64_t freeBytes, std::uint64_t bytesWritten);

private:
    void learnRate(Time now, std::uint64_t bytesWritten);

    std::optional<Time> m_since;
    std::uint64_t m_writtenBefore = 0;
    std::optional<double> m_rate; ///< bytes a second
    std::uint64_t m_warnBytes = kLowBytes;
    double m_warnSeconds = kLowSeconds;
};

/// What the system lets this user write into the directory; nothing when it does not say.
std::optional<std::uint64_t> freeSpaceOf(const std::filesystem::path& directory);

} // namespace hexapose
