// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/log_parts.h"

#include "core/base/input_error.h"
#include "core/record/log_columns.h"

#include <utility>
#include <vector>

namespace hexapose {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kTryPartAgain{2};
constexpr int kMostNames = 100000;
constexpr std::size_t kCopied = std::size_t{1} << 20; ///< bytes between two looks at what came meanwhile

/// The system's words alone: a screen has its own for the rest.
std::string reasonOf(const InputError& error) {
    const InputFault* fault = error.fault();
    return fault != nullptr && !fault->details.empty() ? fault->where + ": " + fault->details.front()
                                                       : error.what();
}

std::size_t headerSize() {
    static const std::size_t size = logHeader().size();
    return size;
}

bool isTaken(const fs::path& csvFile) {
    std::error_code ignored;
    fs::path compressed = csvFile;
    compressed += ".gz";
    return fs::exists(fs::symlink_status(csvFile, ignored)) || fs::exists(compressed, ignored) ||
           fs::exists(logMetadataFile(csvFile), ignored);
}

} // namespace

LogParts::LogParts(const fs::path& csvFile, LogMetadata metadata, std::uint64_t partBytes)
    : m_firstFile(csvFile), m_metadata(std::move(metadata)), m_partBytes(partBytes), m_file(csvFile),
      m_out(std::make_unique<AppendFile>(csvFile)) {
    try {
        writeNewFile(logMetadataFile(csvFile), formatLogMetadata(m_metadata, m_start));
        std::error_code error;
        m_bytes = m_out->append(logHeader(), error);
        if (error) {
            std::error_code ignored;
            fs::remove(logMetadataFile(csvFile), ignored);
            throw InputError(csvFile.string(), "cannot be written: " + error.message());
        }
    } catch (const InputError&) {
        std::error_code ignored;
        fs::remove(csvFile, ignored);
        throw;
    }
}

void LogParts::setSolver(const SolverChoice& solver) {
    m_metadata.solver = solver.name;
    m_metadata.modelFingerprint = solver.modelFingerprint;
}

void LogParts::add(std::string_view row) {
    const std::uint64_t size = m_bytes + m_text.size() - m_textDone;
    const bool isFull = size + row.size() > m_partBytes && size > headerSize();
    // A part that was taken away is no complete one: checkPlace() comes first.
    if (isFull && !m_isCopying && mayTryPart() && write() && m_out->place() == AppendFile::Place::Kept)
        startNext();
    m_text += row;
}

bool LogParts::write() {
    if (m_text.empty()) {
        m_failure = m_partFailure;
        return true;
    }
    std::error_code error;
    const std::size_t done = m_out->append(std::string_view(m_text).substr(m_textDone), error);
    m_bytes += done;
    m_textDone += done;
    // A row that was cut stays whole here: another file may have to begin with it.
    const std::size_t rows = m_textDone == 0 ? 0 : m_text.rfind('\n', m_textDone - 1) + 1;
    m_text.erase(0, rows);
    m_textDone -= rows;
    m_failure = error ? error.message() : m_partFailure;
    return !error;
}

/// The first free name after the first part's, whoever took those before it.
LogParts::NewPart LogParts::makePart(int part) const {
    LogMetadata metadata = m_metadata;
    metadata.part = part;
    metadata.firstPart = m_firstFile.filename().string();
    std::error_code ignored;
    fs::create_directories(m_firstFile.parent_path(), ignored);
    for (int number = 2; number < kMostNames; ++number) {
        NewPart next;
        next.file =
            m_firstFile.parent_path() / (m_firstFile.stem().string() + "-" + std::to_string(number) + ".csv");
        if (isTaken(next.file))
            continue;
        next.out = std::make_unique<AppendFile>(next.file);
        try {
            writeNewFile(logMetadataFile(next.file), formatLogMetadata(metadata, m_start));
        } catch (const InputError&) {
            fs::remove(next.file, ignored);
            throw;
        }
        return next;
    }
    throw InputError(m_firstFile.string(), "every name for another part is taken");
}

bool LogParts::mayTryPart() const {
    return !m_partFailedAt || std::chrono::steady_clock::now() - *m_partFailedAt >= kTryPartAgain;
}

bool LogParts::tryPart(NewPart& next) {
    try {
        next = makePart(m_metadata.part + 1);
        m_partFailedAt.reset();
        m_partFailure.clear();
        return true;
    } catch (const InputError& error) {
        m_partFailedAt = std::chrono::steady_clock::now();
        m_partFailure = reasonOf(error);
        return false;
    }
}

void LogParts::goOnIn(NewPart next, Cause cause, std::uint64_t bytes) {
    if (cause == Cause::Full)
        m_closedParts.push_back(m_file);
    if (cause != Cause::Deleted)
        m_bytesOfParts += m_bytes;
    m_continuations.push_back({cause, next.file.filename().string()});
    m_file = std::move(next.file);
    m_out = std::move(next.out);
    m_bytes = bytes;
    ++m_metadata.part;
}

/// Where it cannot be made the present part becomes larger: nothing is lost.
void LogParts::startNext() {
    NewPart next;
    if (!tryPart(next))
        return;
    m_text = logHeader();
    goOnIn(std::move(next), Cause::Full, 0);
}

bool LogParts::copyAll(AppendFile& to, std::uint64_t& copied, const std::function<void()>& meanwhile) {
    std::vector<char> buffer(kCopied);
    std::error_code error;
    for (;;) {
        const std::size_t count = m_out->read(buffer, copied, error);
        if (!error && count == 0)
            return true;
        if (!error)
            to.append({buffer.data(), count}, error);
        if (error) {
            m_partFailure = error.message();
            m_partFailedAt = std::chrono::steady_clock::now();
            return false;
        }
        copied += count;
        meanwhile();
    }
}

void LogParts::checkPlace(const std::function<void()>& meanwhile) {
    const AppendFile::Place place = m_out->place();
    if (place == AppendFile::Place::Kept) {
        if (m_bytes <= m_partBytes)
            m_partFailure.clear();
        return;
    }
    NewPart next;
    if (!mayTryPart() || !tryPart(next))
        return;
    if (place == AppendFile::Place::Moved) {
        if (m_bytes >= headerSize()) // else it is still here
            m_text.insert(0, logHeader());
        m_textDone = 0;
        return goOnIn(std::move(next), Cause::Moved, 0);
    }
    std::uint64_t copied = 0;
    m_isCopying = true;
    const bool whole = copyAll(*next.out, copied, meanwhile);
    m_isCopying = false;
    if (whole)
        return goOnIn(std::move(next), Cause::Deleted, copied);
    std::error_code ignored;
    fs::remove(next.file, ignored);
    fs::remove(logMetadataFile(next.file), ignored);
}

} // namespace hexapose
