// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/platform_check.h"

#include "core/base/input_error.h"
#include "core/kinematics/singular_home.h"

#include <cstdio>

namespace hexapose {

void requireMovable(const PlatformGeometry& platform, const std::string& nameOrFile) {
    if (const auto fault = faultOfHome(platform))
        throw InputError(nameOrFile, *fault);
}

void warnUnlessMovable(const PlatformGeometry& platform, const std::string& nameOrFile) {
    if (const auto fault = faultOfHome(platform))
        std::fprintf(stderr, "hexapose-cli: warning: %s: %s\n", nameOrFile.c_str(), fault->c_str());
}

} // namespace hexapose
