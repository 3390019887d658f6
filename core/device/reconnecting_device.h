// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace hexapose {

/// Opens a device and opens it again when the port was lost, about once a second, until it is destroyed.
/// Never sends anything but the handshake on its own. While there is no port read() waits a little and
/// reports LinkState::Lost; the notice LinkLost comes once a loss (or once for a first opening that failed),
/// with the reason.
class ReconnectingDevice final : public PlatformDevice {
public:
    /// opener throws ChannelError while the port cannot be opened; it is called on the thread of read().
    using Opener = std::function<std::unique_ptr<PlatformDevice>()>;
    explicit ReconnectingDevice(Opener opener,
                                std::chrono::milliseconds retryEvery = std::chrono::seconds(1));
    ~ReconnectingDevice() override;
    const DeviceFeedback& read() override;
    void write(const SetPoints& setPoints) override;
    void interrupt() override;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace hexapose
