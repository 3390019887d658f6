// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/common/table_problems.h"

#include <cstdio>

namespace hexapose {

bool printProblems(const Table& table) {
    constexpr std::size_t kMost = 100;
    const ProblemList& problems = table.problems();
    const char* const file = table.sourceName().c_str();
    std::size_t printed = 0;
    for (const Problem& problem : problems.first) {
        if (printed++ == kMost)
            break;
        const std::string text = toWords(problem);
        if (problem.line > 0)
            std::fprintf(stderr, "%s:%ld: %s\n", file, problem.line, text.c_str());
        else
            std::fprintf(stderr, "%s: %s\n", file, text.c_str());
    }
    if (problems.count > kMost)
        std::fprintf(stderr, "%s: %llu more\n", file,
                     static_cast<unsigned long long>(problems.count - kMost));
    return problems.rowsLeftOut > 0 || problems.cellsMissing > 0;
}

} // namespace hexapose
