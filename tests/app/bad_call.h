// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/process.h"
#include "tests/app/scratch.h"

#include <string>
#include <vector>

namespace hexapose::apptest {

/// Words of one call, blanks between them, @ for the scratch directory; and what the one line must name.
struct BadCall {
    std::string words;
    std::vector<std::string> said;
    std::string input = {};
};

/// Each ends with status 2 and one line, prints nothing, and leaves every file as it was.
void expectRefused(const std::string& program, const Scratch& scratch, const std::vector<BadCall>& calls);

} // namespace hexapose::apptest
