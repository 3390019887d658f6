// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
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

private:
    int m_descriptor;
};

/// A new file with this text, or none: throws InputError as AppendFile, or when it cannot be written whole.
void writeNewFile(const std::filesystem::path& file, std::string_view text);

} // namespace hexapose
