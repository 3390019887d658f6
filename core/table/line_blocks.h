// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/text_source.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hexapose {

/// Whole lines of a text, one after another.
struct LineBlock {
    std::vector<char> text;
    std::size_t size = 0;      ///< of `text`, that is filled
    std::uint64_t offset = 0;  ///< of its first byte in the text
    bool isLast = false;       ///< its last line may have no end
    std::uint64_t skipped = 0; ///< bytes after it, of a line that is too long
};

/// Cuts a text into blocks of about a mebibyte at the ends of lines that are not within quotes.
class LineBlocks {
public:
    static constexpr std::size_t kBlock = std::size_t{1} << 20;
    static constexpr char kAnySeparator = '\0'; ///< it is not known yet
    static constexpr std::size_t kLongestLine = std::size_t{1} << 26;

    explicit LineBlocks(TextSource& source, std::size_t blockSize = kBlock)
        : m_source(source), m_blockSize(blockSize) {}
    /// Into `block`, whose memory is used again. False at the end.
    bool next(LineBlock& block, char separator);

private:
    void skipLine(LineBlock& block);

    TextSource& m_source;
    std::size_t m_blockSize;
    std::vector<char> m_carry; ///< read already, after the last cut
    std::uint64_t m_offset = 0;
    bool m_ended = false;
};

} // namespace hexapose
