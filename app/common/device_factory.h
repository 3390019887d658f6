// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device/platform_device.h"
#include "core/geometry/platform_geometry.h"
#include "core/session/connection.h"

#include <memory>
#include <string>

namespace hexapose {

/// A device on a serial port that opens again when lost. Called on the thread that will own it.
std::unique_ptr<PlatformDevice> makeSerialDevice(const std::string& portPath, int baud);

/// The built-in virtual platform behind a real pseudo-terminal, opened through the same serial channel.
std::unique_ptr<PlatformDevice> makeVirtualDevice(const PlatformGeometry& geometry);

/// What a session connects to.
std::unique_ptr<PlatformDevice> makeDevice(const ConnectionSpec& connection,
                                           const PlatformGeometry& geometry);

} // namespace hexapose
