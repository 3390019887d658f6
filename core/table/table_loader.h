// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/table.h"
#include "core/table/table_format.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace hexapose {

/// How far the reading of a file is.
struct LoadProgress {
    std::uint64_t bytesRead = 0, bytesInAll = 0; ///< of the file; in all: 0 where not known
    Row rows = 0;
    bool isDone = false;              ///< nothing more will come
    bool isCancelled = false;         ///< before the end of the file
    std::optional<std::string> error; ///< nothing, or no more, can be read: "run.csv: is a directory"
};

/// Reads a file into a table on threads of its own. The table grows meanwhile and can be used from the first
/// block on.
class TableLoader {
public:
    struct Options {
        std::optional<TableFormat> format; ///< empty: found out from the file
        int threads = 0;                   ///< 0: one for each processor
        /// Called from a thread of the loader when progress() has changed, at most some 20 times a second,
        /// and once at the end.
        std::function<void()> onProgress;
        std::size_t blockSize = 0; ///< bytes that are parsed at once, of a known format; 0: a mebibyte
    };

    /// Does not throw for a file that cannot be read: progress() reports it.
    TableLoader(std::filesystem::path file, Options options);
    ~TableLoader(); ///< cancels
    TableLoader(const TableLoader&) = delete;
    TableLoader& operator=(const TableLoader&) = delete;

    void cancel(); ///< what was read stays
    void wait();   ///< for the end
    LoadProgress progress() const;
    /// What has been read so far; never null: empty before the header is known.
    std::shared_ptr<const Table> table() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Reads a whole file. Throws InputError where nothing can be read.
std::shared_ptr<const Table> loadTable(const std::filesystem::path& file,
                                       const std::optional<TableFormat>& format = std::nullopt);

} // namespace hexapose
