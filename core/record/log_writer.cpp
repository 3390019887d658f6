// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/log_writer.h"

#include "core/base/append_file.h"
#include "core/base/input_error.h"
#include "core/record/disk_watch.h"
#include "core/record/event_codec.h"
#include "core/record/log_columns.h"
#include "core/record/log_parts.h"
#include "core/record/part_compressor.h"
#include "core/record/row_choice.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace hexapose {

namespace {

/// Half of the promised 100 ms: the other half is for the system to let the thread run.
constexpr std::chrono::milliseconds kFlushInterval{50};
/// 40 s at 100 Hz; memory is taken once.
constexpr std::size_t kQueueRows = 4096;
constexpr std::size_t kFaultCycles = 500; ///< kept from before a fault
constexpr int kMostFaultFiles = 100;      ///< of a session: a broken line must not fill the disk

using SnapshotPtr = std::shared_ptr<const Snapshot>;

} // namespace

struct LogWriter::Impl {
    Impl(const std::filesystem::path& csvFile, const LogMetadata& metadata, LogOptions theOptions);
    ~Impl();

    void finish();
    bool enqueue(const SnapshotPtr& snapshot);
    void run(const std::stop_token& stop);
    void format();
    bool write();
    void tell(Event event);
    void tellOfParts();
    void watchDisk();
    void remember(const SnapshotPtr& snapshot);
    void writeFaults();

    const std::filesystem::path path;
    const LogOptions options;

    // The loop's side.
    RowChoice choice;
    std::vector<SnapshotPtr> recent; ///< a ring; memory is taken once
    std::size_t nextRecent = 0;
    int faultsSeen = 0;

    // Shared.
    mutable std::mutex mutex;
    std::condition_variable_any wake;
    std::vector<SnapshotPtr> queue;
    bool isUrgent = false; ///< rows are so few that the last one should not wait for another
    std::uint64_t taken = 0;
    std::uint64_t lost = 0;
    std::uint64_t lostUnreported = 0; ///< since the last row that counts it
    std::string writeFailure;
    std::string faultFailure;
    std::filesystem::path file;
    std::vector<Event> events; ///< to be reported
    std::atomic<bool> hasEvents = false;
    std::vector<std::vector<SnapshotPtr>> faults; ///< to be written, each from the oldest cycle on

    // The writer's side.
    int faultFiles = 0;
    std::vector<SnapshotPtr> batch;
    std::string row;
    LogParts parts;
    PartCompressor compressor;
    DiskWatch disk;
    std::chrono::steady_clock::time_point nextLook{}; ///< at the disk
    bool failing = false;

    std::jthread thread;
};

LogWriter::Impl::Impl(const std::filesystem::path& csvFile, const LogMetadata& metadata,
                      LogOptions theOptions)
    : path(csvFile), options(std::move(theOptions)), file(csvFile),
      parts(csvFile, metadata, options.partBytes), compressor(options.compress) {
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

/// Whether the writer should be woken.
bool LogWriter::Impl::enqueue(const SnapshotPtr& snapshot) {
    if (queue.size() == kQueueRows) {
        ++lost;
        ++lostUnreported;
        return false;
    }
    queue.push_back(snapshot);
    ++taken;
    return queue.size() == kQueueRows / 2;
}

void LogWriter::Impl::run(const std::stop_token& stop) {
    for (bool last = false; !last;) {
        {
            std::unique_lock lock(mutex);
            // While writing fails a full queue is no reason to write early.
            const bool writeEarly = !parts.hasUnwritten();
            wake.wait_for(lock, stop, kFlushInterval,
                          [&] { return writeEarly && (isUrgent || queue.size() >= kQueueRows / 2); });
            isUrgent = false;
            last = stop.stop_requested();
        }
        writeFaults();
        watchDisk();
        parts.checkPlace([this] { format(); });
        // What is left from a failed attempt first, then what has come since.
        if (write()) {
            format();
            write();
        }
        if (last) { // taken away since: nobody looks after this
            parts.checkPlace([] {});
            write();
        }
    }
    compressor.finish();
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
        std::filesystem::path kept;
        std::error_code ignored;
        do
            kept = faultFile(path, ++faultFiles);
        while (std::filesystem::exists(kept, ignored));
        try {
            writeNewFile(kept, rows);
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
    std::uint64_t lostBefore = 0;
    {
        const std::lock_guard lock(mutex);
        std::swap(queue, batch);
        lostBefore = std::exchange(lostUnreported, 0);
    }
    if (lostBefore > 0 && !batch.empty()) {
        auto last = std::make_shared<Snapshot>(*batch.back()); // others may read this one
        last->events.push_back({EventCode::LogFailed, LogFailure{lostBefore, {}}});
        batch.back() = std::move(last);
    }
    for (const SnapshotPtr& snapshot : batch) {
        for (const Event& event : snapshot->events)
            if (const auto* solver = event.get<SolverChoice>())
                parts.setSolver(*solver);
        row.clear();
        appendLogRow(*snapshot, row);
        parts.add(row);
    }
    batch.clear();
}

/// False while bytes are left that the system did not take.
bool LogWriter::Impl::write() {
    const bool done = parts.write();
    tellOfParts();
    {
        const std::lock_guard lock(mutex);
        writeFailure = parts.failure();
        file = parts.file();
    }
    const bool fails = !parts.failure().empty();
    if (fails && !failing)
        tell({EventCode::LogFailed, LogFailure{0, parts.failure()}});
    failing = fails;
    return done;
}

void LogWriter::Impl::tell(Event event) {
    const std::lock_guard lock(mutex);
    events.push_back(std::move(event));
    hasEvents = true;
}

void LogWriter::Impl::tellOfParts() {
    for (LogContinuation& continuation : parts.takeContinuations())
        tell({EventCode::LogContinued, std::move(continuation)});
    for (const std::filesystem::path& part : parts.takeClosedParts())
        compressor.add(part);
}

void LogWriter::Impl::watchDisk() {
    const auto now = std::chrono::steady_clock::now();
    if (now < nextLook)
        return;
    nextLook = now + options.watchDiskEvery;
    const std::filesystem::path directory = path.parent_path();
    const auto bytes = options.freeSpace ? options.freeSpace(directory) : freeSpaceOf(directory);
    if (!bytes)
        return;
    if (const std::optional<LogSpace> low = disk.update(now, *bytes, parts.bytesWritten()))
        tell({EventCode::LogSpaceLow, *low});
}

LogWriter::LogWriter(const std::filesystem::path& csvFile, const LogMetadata& metadata, LogOptions options)
    : m_impl(std::make_unique<Impl>(csvFile, metadata, std::move(options))) {}

LogWriter::~LogWriter() = default;

void LogWriter::append(const SnapshotPtr& snapshot) {
    m_impl->remember(snapshot);
    const std::span<const SnapshotPtr> rows = m_impl->choice.add(snapshot);
    if (rows.empty())
        return;
    bool wakes = m_impl->choice.isAtRest();
    {
        const std::lock_guard lock(m_impl->mutex);
        m_impl->isUrgent = m_impl->isUrgent || wakes;
        for (const SnapshotPtr& row : rows)
            wakes = m_impl->enqueue(row) || wakes;
    }
    if (wakes)
        m_impl->wake.notify_one();
}

void LogWriter::takeEvents(std::vector<Event>& events) {
    if (!m_impl->hasEvents)
        return;
    const std::lock_guard lock(m_impl->mutex);
    for (Event& event : m_impl->events)
        events.push_back(std::move(event));
    m_impl->events.clear();
    m_impl->hasEvents = false;
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

std::filesystem::path LogWriter::file() const {
    const std::lock_guard lock(m_impl->mutex);
    return m_impl->file;
}

std::filesystem::path faultFile(const std::filesystem::path& csvFile, int number) {
    return csvFile.parent_path() / (csvFile.stem().string() + "-fault-" + std::to_string(number) + ".csv");
}

} // namespace hexapose
