// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/log_options.h"

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <thread>

namespace hexapose {

/// Compresses closed parts, one after another, on a thread of its own: run.csv becomes run.csv.gz. A part is
/// removed only once the whole of it is there compressed; nothing is overwritten.
class PartCompressor {
public:
    /// Without `compress` nothing happens.
    explicit PartCompressor(decltype(LogOptions::compress) compress);
    ~PartCompressor(); ///< as finish()
    PartCompressor(const PartCompressor&) = delete;
    PartCompressor& operator=(const PartCompressor&) = delete;

    void add(const std::filesystem::path& part);
    /// Waits a little for what is under way; a part that is not ready by then stays as it is.
    void finish();

private:
    void run(const std::stop_token& stop);
    void replace(const std::filesystem::path& part, const std::stop_token& stop) const;

    const decltype(LogOptions::compress) m_compress;
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::deque<std::filesystem::path> m_parts; ///< the first one is under way
    std::jthread m_thread;
};

} // namespace hexapose
