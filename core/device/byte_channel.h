// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hexapose {

/// The port is gone or cannot be opened; what() is the system's reason.
class ChannelError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Bytes to and from a controller. One thread owns it.
class ByteChannel {
public:
    virtual ~ByteChannel() = default;
    /// Bytes that arrived, waiting up to `wait` for the first; 0 when none came. Throws ChannelError once the
    /// port is gone.
    virtual std::size_t read(std::span<char> buffer, std::chrono::milliseconds wait) = 0;
    /// All bytes are handed to the system before it returns. Throws ChannelError.
    virtual void write(std::string_view bytes) = 0;
    /// Bytes that were written and wait in this computer; 0 where that cannot be known.
    virtual std::size_t unsent() { return 0; }
    /// Forgets what waits, so that the next write goes out at once. The other side sees a torn frame at most.
    virtual void dropUnsent() {}
};

} // namespace hexapose
