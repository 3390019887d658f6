// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/log_writer.h"

#include "core/base/append_file.h"
#include "core/base/input_error.h"
#include "core/record/log_columns.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace hexapose {

namespace {

/// Half of the promised 100 ms: the other half is for the system to let the thread run.
constexpr std::chrono::milliseconds kFlushInterval{50};
constexpr std::chrono::nanoseconds kQuietRowInterval = std::chrono::milliseconds(100);
/// 40 s at 100 Hz; memory is taken once.
constexpr std::size_t kQueueRows = 4096;
constexpr std::size_t kFaultCycles = 500; ///< kept from before a fault
constexpr int kMostFaultFiles = 100;      ///< of a session: a broken line must not fill the disk

using SnapshotPtr = std::shared_ptr<const Snapshot>;

} // namespace

struct LogWriter::Impl {
    Impl(const std::filesystem::path& csvFile, const LogMetadata& metadata);
    ~Impl();

    void finish();
    bool becomesRow(const Snapshot& snapshot);
    void run(const std::stop_token& stop);
    void format();
    bool write();
    void remember(const SnapshotPtr& snapshot);
    void writeFaults();

    std::filesystem::path path;
    AppendFile out;

    // The loop's side.
    std::optional<RunState> lastState;
    std::chrono::nanoseconds lastRowTime{0};
    std::vector<SnapshotPtr> recent; ///< a ring; memory is taken once
    std::size_t nextRecent = 0;
    int faultsSeen = 0;

    // Shared.
    mutable std::mutex mutex;
    std::condition_variable_any wake;
    std::vector<SnapshotPtr> queue;
    std::uint64_t taken = 0;
    std::uint64_t lost = 0;
    std::uint64_t lostUnreported = 0; ///< since the last row that counts it
    std::string writeFailure;
    std::string faultFailure;
    std::vector<std::vector<SnapshotPtr>> faults; ///< to be written, each from the oldest cycle on

    // The writer's side.
    int faultFiles = 0;
    std::vector<SnapshotPtr> batch;
    std::string text; ///< formatted and not yet written
    std::size_t textDone = 0;

    std::jthread thread;
};

LogWriter::Impl::Impl(const std::filesystem::path& csvFile, const LogMetadata& metadata)
    : path(csvFile), out(csvFile) {
    try {
        writeNewFile(logMetadataFile(csvFile), formatLogMetadata(metadata, std::chrono::system_clock::now()));
        std::error_code error;
        out.append(logHeader(), error);
        if (error) {
            std::error_code ignored;
            std::filesystem::remove(logMetadataFile(csvFile), ignored);
            throw InputError(path.string(), "cannot be written: " + error.message());
        }
    } catch (const InputError&) {
        std::error_code ignored;
        std::filesystem::remove(csvFile, ignored);
        throw;
    }
    recent.reserve(kFaultCycles);
    queue.reserve(kQueueRows);
    batch.reserve(kQueueRows);
    thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

LogWriter::Impl::~Impl() {
    finish();
}

void LogWriter::Impl::finish() {
    if (!thread.joinable())
        return;
    thread.request_stop();
    thread.join();
}

bool LogWriter::Impl::becomesRow(const Snapshot& snapshot) {
    const bool row = snapshot.fresh || !snapshot.events.empty() || lastState != snapshot.state ||
                     snapshot.time - lastRowTime >= kQuietRowInterval;
    if (row) {
        lastState = snapshot.state;
        lastRowTime = snapshot.time;
    }
    return row;
}

void LogWriter::Impl::run(const std::stop_token& stop) {
    for (bool last = false; !last;) {
        {
            std::unique_lock lock(mutex);
            // While writing fails a full queue is no reason to write early.
            const bool writeEarly = text.empty();
            wake.wait_for(lock, stop, kFlushInterval,
                          [&] { return writeEarly && queue.size() >= kQueueRows / 2; });
            last = stop.stop_requested();
        }
        writeFaults();
        // What is left from a failed attempt first, then what has come since.
        if (!write())
            continue;
        format();
        write();
    }
}

/// Every cycle, on the loop's side; a fault hands all that is remembered over to the writer.
void LogWriter::Impl::remember(const SnapshotPtr& snapshot) {
    if (recent.size() < kFaultCycles)
        recent.push_back(snapshot);
    else
        recent[nextRecent] = snapshot;
    nextRecent = (nextRecent + 1) % kFaultCycles;
    const auto isBad = [](const Event& event) { return isFault(event.code); };
    if (std::none_of(snapshot->events.begin(), snapshot->events.end(), isBad) ||
        ++faultsSeen > kMostFaultFiles)
        return;
    std::vector<SnapshotPtr> record;
    const std::size_t first = recent.size() < kFaultCycles ? 0 : nextRecent;
    for (std::size_t k = 0; k < recent.size(); ++k)
        record.push_back(recent[(first + k) % recent.size()]);
    const std::lock_guard lock(mutex);
    faults.push_back(std::move(record));
}

void LogWriter::Impl::writeFaults() {
    std::vector<std::vector<SnapshotPtr>> records;
    {
        const std::lock_guard lock(mutex);
        records.swap(faults);
    }
    for (const std::vector<SnapshotPtr>& record : records) {
        std::string rows = logHeader();
        for (const SnapshotPtr& snapshot : record)
            appendLogRow(*snapshot, rows);
        std::filesystem::path file;
        std::error_code ignored;
        do
            file = faultFile(path, ++faultFiles);
        while (std::filesystem::exists(file, ignored));
        try {
            writeNewFile(file, rows);
        } catch (const InputError& error) {
            const std::lock_guard lock(mutex);
            // The system's words alone: a screen has its own for the rest.
            const InputFault* fault = error.fault();
            faultFailure = fault != nullptr && !fault->details.empty()
                               ? fault->where + ": " + fault->details.front()
                               : error.what();
        }
    }
}

/// Takes the queue and turns it into text.
void LogWriter::Impl::format() {
    std::uint64_t untold = 0;
    {
        const std::lock_guard lock(mutex);
        std::swap(queue, batch);
        untold = std::exchange(lostUnreported, 0);
    }
    if (untold > 0 && !batch.empty()) {
        auto last = std::make_shared<Snapshot>(*batch.back()); // others may read this one
        last->events.push_back({EventCode::LogFailed, LogFailure{untold, {}}});
        batch.back() = std::move(last);
    }
    for (const SnapshotPtr& snapshot : batch)
        appendLogRow(*snapshot, text);
    batch.clear();
}

/// False while bytes are left that the system did not take.
bool LogWriter::Impl::write() {
    if (text.empty())
        return true;
    std::error_code error;
    textDone += out.append(std::string_view(text).substr(textDone), error);
    if (!error) {
        text.clear();
        textDone = 0;
    }
    const std::lock_guard lock(mutex);
    writeFailure = error ? error.message() : std::string();
    return !error;
}

LogWriter::LogWriter(const std::filesystem::path& csvFile, const LogMetadata& metadata)
    : m_impl(std::make_unique<Impl>(csvFile, metadata)) {}

LogWriter::~LogWriter() = default;

void LogWriter::append(const SnapshotPtr& snapshot) {
    m_impl->remember(snapshot);
    if (!m_impl->becomesRow(*snapshot))
        return;
    bool halfFull = false;
    {
        const std::lock_guard lock(m_impl->mutex);
        if (m_impl->queue.size() == kQueueRows) {
            ++m_impl->lost;
            ++m_impl->lostUnreported;
            return;
        }
        m_impl->queue.push_back(snapshot);
        ++m_impl->taken;
        halfFull = m_impl->queue.size() == kQueueRows / 2;
    }
    if (halfFull)
        m_impl->wake.notify_one();
}

void LogWriter::finish() {
    m_impl->finish();
}

std::uint64_t LogWriter::rowCount() const {
    const std::lock_guard lock(m_impl->mutex);
    return m_impl->taken;
}

std::uint64_t LogWriter::lostCount() const {
    const std::lock_guard lock(m_impl->mutex);
    return m_impl->lost;
}

std::optional<LogFailure> LogWriter::failure() const {
    const std::lock_guard lock(m_impl->mutex);
    if (!m_impl->writeFailure.empty())
        return LogFailure{0, m_impl->writeFailure};
    if (!m_impl->faultFailure.empty())
        return LogFailure{0, m_impl->faultFailure};
    if (m_impl->lost > 0)
        return LogFailure{m_impl->lost, {}};
    return std::nullopt;
}

const std::filesystem::path& LogWriter::file() const {
    return m_impl->path;
}

std::filesystem::path faultFile(const std::filesystem::path& csvFile, int number) {
    return csvFile.parent_path() / (csvFile.stem().string() + "-fault-" + std::to_string(number) + ".csv");
}

} // namespace hexapose
