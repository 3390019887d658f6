// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/byte_channel.h"
#include "core/device/platform_device.h"

#include <chrono>
#include <functional>
#include <memory>

namespace hexapose {

struct LineDeviceOptions {
    std::chrono::milliseconds desiredPeriod{10}; ///< of the feedback; asked for once the controller is known
    std::chrono::milliseconds longestWait{15};   ///< of one exchange for a measurement
    std::chrono::milliseconds helloEvery{400};   ///< until the controller identifies itself
    std::chrono::milliseconds aliveEvery{
        100}; ///< asked again, while enabled drives may not have set-points yet
    std::chrono::milliseconds answerWithin{1000}; ///< then the answer is missed
    std::chrono::milliseconds stopEvery{100};     ///< until the stop, or the disabling, is confirmed
    std::chrono::milliseconds stopGiveUpAfter{5000};
    std::chrono::milliseconds silentAfter{1000}; ///< no good frame for so long: no set-points, ask again
    std::chrono::milliseconds pauseOfSender{50}; ///< a byte after such a pause begins a line
    std::function<std::chrono::steady_clock::time_point()> now = std::chrono::steady_clock::now;
};

/// A controller that speaks the line protocol, or a listen-only sender of lengths.
class LineDevice final : public PlatformDevice {
public:
    explicit LineDevice(std::unique_ptr<ByteChannel> channel, LineDeviceOptions options = {});
    ~LineDevice() override;
    const DeviceFeedback& read() override;
    void write(const SetPoints& setPoints) override;
    void interrupt() override;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace hexapose
