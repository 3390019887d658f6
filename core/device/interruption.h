// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/file_descriptor.h"

#include <chrono>

namespace hexapose {

/// A request of any thread that the one which waits for bytes shall wait no longer. The system's poll() sees
/// it, so that one wait is for both.
class Interruption {
public:
    /// Throws std::system_error where the system has no descriptor left.
    Interruption();
    /// From any thread.
    void request();
    /// Whether there was a request; there is none afterwards.
    bool take();
    /// Whether there is a request; it stays.
    bool requested() const;
    /// Until a request, which is taken, or for so long.
    void wait(std::chrono::milliseconds longest);
    /// Readable while there is a request.
    int descriptor() const { return m_event.get(); }

private:
    FileDescriptor m_event;
};

} // namespace hexapose
