// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/byte_channel.h"

#include <memory>
#include <string>

namespace hexapose {

/// A serial port, 8N1, no flow control. Opened, used and destroyed on one thread.
class SerialChannel final : public ByteChannel {
public:
    /// path: a device, a pseudo-terminal, or a symbolic link to one. Throws ChannelError with the reason and,
    /// for a port the user may not open, with what to do about it.
    SerialChannel(const std::string& path, int baud);
    ~SerialChannel() override;

    std::size_t read(std::span<char> buffer, std::chrono::milliseconds wait,
                     const Interruption& interruption) override;
    void write(std::string_view bytes) override;
    std::size_t unsent() override;
    void dropUnsent() override;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace hexapose
