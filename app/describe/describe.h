// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/usage.h"

#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// A program as its tables of options tell it: man page and completions are made of these when it is built,
/// by `PROGRAM --describe FORM`, so that they cannot differ from what the program parses.
struct ProgramDescription {
    struct Command {
        std::string name;
        std::string summary; ///< "leg lengths of poses"
        Usage usage;
    };

    std::string name;
    Usage usage; ///< of a program without commands
    std::vector<Command>
        commands; ///< each the first word of a call; such a program itself takes --help, --version
};

/// `PROGRAM --describe FORM`, to standard output; returns the exit status. FORM: "man" (the sections about
/// options and commands, in roff), "bash", "zsh" or "fish" (its completion).
int printDescription(const ProgramDescription& program, std::string_view form);

} // namespace hexapose
