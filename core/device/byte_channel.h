// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/interruption.h"
#include "core/record/device_words.h"
#include "core/record/port_failure.h"

#include <chrono>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace hexapose {

/// The port is gone or cannot be opened.
class ChannelError : public std::runtime_error {
public:
    explicit ChannelError(PortFailure failure)
        : std::runtime_error(toWords(failure)), m_failure(std::move(failure)) {}
    /// For a reason that has no kind of its own.
    explicit ChannelError(const std::string& reason)
        : ChannelError(PortFailure{PortFailure::Kind::Other, {}, reason}) {}
    const PortFailure& failure() const { return m_failure; }

private:
    PortFailure m_failure;
};

/// Bytes to and from a controller. One thread owns it.
class ByteChannel {
public:
    virtual ~ByteChannel() = default;
    /// Bytes that arrived, waiting for the first up to `wait`, or until an interruption is requested, which
    /// is left to the caller to take; 0 when none came. Throws ChannelError once the port is gone.
    virtual std::size_t read(std::span<char> buffer, std::chrono::milliseconds wait,
                             const Interruption& interruption) = 0;
    /// All bytes are handed to the system before it returns. Throws ChannelError.
    virtual void write(std::string_view bytes) = 0;
    /// Bytes that were written and wait in this computer; 0 where that cannot be known.
    virtual std::size_t unsent() { return 0; }
    /// Forgets what waits, so that the next write goes out at once. The other side sees a torn frame at most.
    virtual void dropUnsent() {}
};

} // namespace hexapose
