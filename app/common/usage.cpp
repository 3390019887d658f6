// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/common/usage.h"

namespace hexapose {

std::vector<OptionSpec> Usage::allOptions() const {
    std::vector<OptionSpec> all = options;
    if (!platformHelp.empty())
        all.push_back({"platform", "NAME|FILE", platformHelp});
    all.push_back({"help", "", "Show this help."});
    return all;
}

} // namespace hexapose
