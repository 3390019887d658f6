// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/part_compressor.h"

#include <chrono>
#include <system_error>
#include <utility>

#include <sys/resource.h>
#include <unistd.h>

namespace hexapose {

namespace {

constexpr std::chrono::seconds kPatience{2}; ///< at the end: somebody waits for it
constexpr int kLowestPriority = 19;

} // namespace

PartCompressor::PartCompressor(decltype(LogOptions::compress) compress) : m_compress(std::move(compress)) {
    if (m_compress)
        m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

PartCompressor::~PartCompressor() {
    finish();
}

void PartCompressor::add(const std::filesystem::path& part) {
    if (!m_thread.joinable())
        return;
    const std::lock_guard lock(m_mutex);
    m_parts.push_back(part);
    m_changed.notify_all();
}

void PartCompressor::finish() {
    if (!m_thread.joinable())
        return;
    {
        std::unique_lock lock(m_mutex);
        m_changed.wait_for(lock, kPatience, [this] { return m_parts.empty(); });
    }
    m_thread.request_stop();
    m_thread.join();
}

void PartCompressor::run(const std::stop_token& stop) {
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kLowestPriority); // of this thread alone
    std::unique_lock lock(m_mutex);
    while (m_changed.wait(lock, stop, [this] { return !m_parts.empty(); }) && !stop.stop_requested()) {
        const std::filesystem::path part = m_parts.front();
        lock.unlock();
        replace(part, stop);
        lock.lock();
        m_parts.pop_front();
        m_changed.notify_all();
    }
}

void PartCompressor::replace(const std::filesystem::path& part, const std::stop_token& stop) const {
    std::filesystem::path whole = part;
    whole += ".gz";
    std::filesystem::path unfinished = whole;
    unfinished += ".tmp"; // a program that is killed leaves no half of a .gz
    if (!m_compress(part, unfinished, stop))
        return;
    std::error_code error;
    std::error_code ignored;
    std::filesystem::create_hard_link(unfinished, whole, error); // fails where there is one, unlike rename
    if (error && !std::filesystem::exists(whole, ignored))       // a file system without links
        std::filesystem::rename(unfinished, whole, error);
    std::filesystem::remove(unfinished, ignored);
    if (!error)
        std::filesystem::remove(part, ignored);
}

} // namespace hexapose
