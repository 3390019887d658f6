// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace hexapose {

/// The text of a file as UTF-8 without byte order mark, from UTF-8, UTF-16 with a byte order mark, or either
/// of them compressed by gzip (which its content decides, not its name). Read with pread: a file that
/// shrinks meanwhile ends early, and nothing else happens.
class TextSource {
public:
    /// Throws InputError with the reason: "run.csv: is a directory". "-" is standard input.
    /// isCancelled: asked while a pipe is silent; the text ends there when it says so.
    explicit TextSource(const std::filesystem::path& file, std::function<bool()> isCancelled = {});
    ~TextSource();
    TextSource(const TextSource&) = delete;
    TextSource& operator=(const TextSource&) = delete;

    const std::string& name() const;
    /// The next bytes, as many as there are room for, or fewer; 0 at the end. Throws InputError.
    std::size_t read(std::span<char> buffer);
    /// Whether the text is the file's own bytes; then the place in the file of the text's first byte.
    bool isPlain() const;
    std::uint64_t textBegin() const;
    /// Of the file: read so far, and its size when it was opened; 0 where that is not known.
    std::uint64_t bytesRead() const;
    std::uint64_t size() const;
    /// It has become shorter while it was read.
    bool hasShrunk() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace hexapose
