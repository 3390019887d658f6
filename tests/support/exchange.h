// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"

namespace hexapose {

/// One cycle of a device: what goes out, then what comes back.
inline DeviceFeedback exchange(PlatformDevice& device, const SetPoints& setPoints) {
    device.write(setPoints);
    return device.read();
}

} // namespace hexapose
