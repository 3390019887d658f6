// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/usage.h"

#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// What a shell can offer for the value of an option, or for an operand.
struct Values {
    std::vector<std::string> words;
    bool files = false;
    std::string suffix; ///< of the files; empty: any
    bool directories = false;

    bool none() const { return words.empty() && !files && !directories; }
};

Values valuesOf(const OptionSpec& option);
/// Of all operands together: no program takes two of different kinds.
Values valuesOf(const QStringList& operands);

} // namespace hexapose
