// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hexapose {

/// Something in a file that is not as it should be.
struct Problem {
    enum class Kind {
        NotANumber,     ///< text: the cell; it counts as missing
        NotATime,       ///< text: the cell; the row's time counts as missing
        TooFewFields,   ///< count, expected; the row is left out
        TooManyFields,  ///< count, expected; the row is left out
        HalfWritten,    ///< the last line, left out; with a column: that cell, which may be cut
        QuoteNotClosed, ///< the last line, left out
        TimeGoesBack,   ///< the row is kept, in the file's order
        TimeRepeated,   ///< the row is kept
        RenamedColumn,  ///< text: its new name; the name was there already
        NoName,         ///< text: its new name; the column had none
        LineTooLong,    ///< left out
        FileChanged,    ///< it became shorter while it was read, or ends within its compression
    };
    Kind kind{};
    long line = 0;           ///< 1-based; 0: of the file as a whole
    std::string column = {}; ///< its name; empty: of the row as a whole
    std::string text = {};
    std::size_t count = 0, expected = 0;
};

/// "l3_mm: \"12a\" is not a number": without the file and the line.
std::string toWords(const Problem& problem);

/// The first ones in full, and how many there are in all.
struct ProblemList {
    static constexpr std::size_t kMost = 10000;
    std::vector<Problem> first; ///< by line
    std::uint64_t count = 0;
    std::uint64_t rowsLeftOut = 0;
    std::uint64_t cellsMissing = 0; ///< for a cause; an empty cell is none

    bool isEmpty() const { return count == 0; }
};

} // namespace hexapose
