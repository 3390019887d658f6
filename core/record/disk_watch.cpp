// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/disk_watch.h"

#include <system_error>

namespace hexapose {

namespace {

constexpr double kLeastSpan = 10.0;   ///< s, over which a rate is taken
constexpr double kNewerWeight = 0.25; ///< of a span against all before it
constexpr double kRecovered = 1.5;    ///< times the limit: then the next fall below it is news again

} // namespace

void DiskWatch::learnRate(Time now, std::uint64_t bytesWritten) {
    if (!m_since) {
        m_since = now;
        m_writtenBefore = bytesWritten;
        return;
    }
    const double span = std::chrono::duration<double>(now - *m_since).count();
    if (span < kLeastSpan)
        return;
    const double rate = static_cast<double>(bytesWritten - m_writtenBefore) / span;
    m_rate = m_rate ? (1.0 - kNewerWeight) * *m_rate + kNewerWeight * rate : rate;
    m_since = now;
    m_writtenBefore = bytesWritten;
}

std::optional<LogSpace> DiskWatch::update(Time now, std::uint64_t freeBytes, std::uint64_t bytesWritten) {
    learnRate(now, bytesWritten);
    LogSpace space{freeBytes, {}};
    if (m_rate && *m_rate > 0.0)
        space.secondsLeft = static_cast<double>(freeBytes) / *m_rate;
    const bool low = freeBytes < m_warnBytes;
    const bool soon = space.secondsLeft && *space.secondsLeft < m_warnSeconds;
    if (low)
        m_warnBytes = freeBytes / 2;
    else if (static_cast<double>(freeBytes) > kRecovered * static_cast<double>(kLowBytes))
        m_warnBytes = kLowBytes;
    if (soon)
        m_warnSeconds = *space.secondsLeft / 2.0;
    else if (space.secondsLeft && *space.secondsLeft > kRecovered * kLowSeconds)
        m_warnSeconds = kLowSeconds;
    return low || soon ? std::optional(space) : std::nullopt;
}

std::optional<std::uint64_t> freeSpaceOf(const std::filesystem::path& directory) {
    std::error_code error;
    const std::filesystem::space_info space =
        std::filesystem::space(directory.empty() ? std::filesystem::path(".") : directory, error);
    return error ? std::nullopt : std::optional<std::uint64_t>(space.available);
}

} // namespace hexapose
