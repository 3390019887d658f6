// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/platform_check.h"

#include "core/base/input_error.h"
#include "core/kinematics/singular_home.h"

namespace hexapose {

void requireMovable(const PlatformGeometry& platform, const std::string& nameOrFile) {
    if (const auto fault = faultOfHome(platform))
        throw InputError(nameOrFile, *fault);
}

} // namespace hexapose
