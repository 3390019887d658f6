// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/line_blocks.h"

#include <algorithm>
#include <cstring>

namespace hexapose {

namespace {

/// A '\r' at the very end may belong to a '\n' that is still to come, unless `isLast`.
std::size_t lastLineEnd(const char* text, std::size_t size, bool isLast) {
    for (std::size_t i = size; i-- > 0;)
        if (text[i] == '\n' || (text[i] == '\r' && (i + 1 < size || isLast)))
            return i + 1;
    return 0;
}

/// Whether a character parts fields; any that commonly does where the separator is not known yet.
bool parts(char separator, char c) {
    return separator != LineBlocks::kAnySeparator ? c == separator
                                                  : c == ',' || c == ';' || c == '\t' || c == '|';
}

/// Where the last line ends that is complete, in a text that begins outside of quotes; 0: none does.
std::size_t findCut(const char* text, std::size_t size, char separator, bool isLast) {
    if (std::memchr(text, '"', size) == nullptr)
        return lastLineEnd(text, size, isLast);
    // A quote opens a field only at its start; within, two of them are one.
    std::size_t cut = 0;
    bool inQuote = false, atStart = true;
    for (std::size_t i = 0; i < size; ++i) {
        const char c = text[i];
        if (inQuote) {
            if (c != '"')
                continue;
            if (i + 1 < size && text[i + 1] == '"')
                ++i;
            else
                inQuote = false;
        } else if (c == '"' && atStart) {
            inQuote = true;
            atStart = false;
        } else if (c == '\n' || (c == '\r' && (i + 1 < size || isLast))) {
            cut = i + 1;
            atStart = true;
        } else {
            atStart = parts(separator, c) || (atStart && c == ' ');
        }
    }
    return cut;
}

} // namespace

bool LineBlocks::next(LineBlock& block, char separator) {
    block.skipped = 0;
    block.isLast = false;
    block.offset = m_offset;
    if (m_ended && m_carry.empty())
        return false;
    block.text.resize(std::max(block.text.size(), std::max(m_blockSize, 2 * m_carry.size())));
    if (!m_carry.empty())
        std::memcpy(block.text.data(), m_carry.data(), m_carry.size());
    block.size = m_carry.size();
    m_carry.clear();
    for (;;) {
        while (!m_ended && block.size < block.text.size()) {
            const std::size_t count = m_source.read(std::span(block.text).subspan(block.size));
            m_ended = count == 0;
            block.size += count;
        }
        const std::size_t cut = findCut(block.text.data(), block.size, separator, m_ended);
        if (m_ended) {
            block.isLast = true;
            m_offset += block.size;
            return block.size > 0;
        }
        if (cut > 0) {
            m_carry.assign(block.text.begin() + static_cast<std::ptrdiff_t>(cut),
                           block.text.begin() + static_cast<std::ptrdiff_t>(block.size));
            block.size = cut;
            m_offset += block.size;
            return true;
        }
        if (block.size >= kLongestLine) {
            skipLine(block);
            return true;
        }
        block.text.resize(2 * block.text.size());
    }
}

/// The block is one line without an end so far: its beginning is forgotten, and the rest of it passed over.
void LineBlocks::skipLine(LineBlock& block) {
    block.skipped = block.size;
    for (;;) {
        const std::size_t count = m_source.read(block.text);
        m_ended = count == 0;
        const char* const begin = block.text.data();
        const char* const end =
            std::find_if(begin, begin + count, [](char c) { return c == '\n' || c == '\r'; });
        if (m_ended || end != begin + count) {
            const std::size_t used = m_ended ? 0 : static_cast<std::size_t>(end - begin) + 1;
            m_carry.assign(begin + used, begin + count);
            block.skipped += used;
            m_offset += block.skipped;
            block.size = 0;
            block.text.resize(m_blockSize);
            return;
        }
        block.skipped += count;
    }
}

} // namespace hexapose
