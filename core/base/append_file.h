// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>

namespace hexapose {

/// A new file whose bytes are with the system as soon as append() returns: they survive the end of the
/// program, whatever ends it.
class AppendFile {
public:
    /// Throws InputError when the file exists already or cannot be created.
    explicit AppendFile(const std::filesystem::path& file);
    ~AppendFile();
    AppendFile(const AppendFile&) = delete;
    AppendFile& operator=(const AppendFile&) = delete;

    /// How many of the bytes were written; fewer than all when `error` is set.
    std::size_t append(std::string_view bytes, std::error_code& error) noexcept;
    /// What has been written, from a place on, also of a file that has no name any more; 0 at the end.
    std::size_t read(std::span<char> buffer, std::uint64_t from, std::error_code& error) noexcept;

    /// What others did to the file since it was made.
    enum class Place {
        Kept,    ///< it is where it was made, as long as it was written or longer
        Deleted, ///< no name is left: it is gone with this object
        Moved,   ///< it has another name, another file stands in its place, or it was cut
    };
    Place place() const noexcept;

private:
    std::filesystem::path m_path;
    int m_descriptor;
    std::uint64_t m_size = 0; ///< written
};

/// A new file with this text, or none: throws InputError as AppendFile, or when it cannot be written whole.
void writeNewFile(const std::filesystem::path& file, std::string_view text);

} // namespace hexapose
