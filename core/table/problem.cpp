// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/problem.h"

namespace hexapose {

std::string toWords(const Problem& problem) {
    const std::string column = problem.column.empty() ? "" : problem.column + ": ";
    const std::string quoted = "\"" + problem.text + "\"";
    const auto fields = [&] {
        return std::to_string(problem.count) +
               (problem.count == 1 ? " field, but the header has " : " fields, but the header has ") +
               std::to_string(problem.expected);
    };
    switch (problem.kind) {
    case Problem::Kind::NotANumber:
        return column + quoted + " is not a number";
    case Problem::Kind::NotATime:
        return column + quoted + " is not a time";
    case Problem::Kind::TooFewFields:
    case Problem::Kind::TooManyFields:
        return "row left out: " + fields();
    case Problem::Kind::HalfWritten:
        return problem.column.empty()
                   ? "half-written last line left out: " + fields()
                   : column + quoted + " at the end of the file may be cut and is not shown";
    case Problem::Kind::QuoteNotClosed:
        return "row left out: a quote is opened and never closed";
    case Problem::Kind::TimeGoesBack:
        return column + "time goes back";
    case Problem::Kind::TimeRepeated:
        return column + "time is repeated";
    case Problem::Kind::RenamedColumn:
        return "the name is there already; the column is called " + quoted;
    case Problem::Kind::NoName:
        return "a column without a name is called " + quoted;
    case Problem::Kind::LineTooLong:
        return "row left out: a line of " + std::to_string(problem.count) + " bytes";
    case Problem::Kind::FileChanged:
        return "the file ends before its size";
    }
    return {};
}

} // namespace hexapose
