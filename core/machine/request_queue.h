// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/device_refusal.h"

#include <utility>

namespace hexapose {

/// What is to be asked of the controller, one request a cycle. Stop goes first and drops what was asked
/// before it; a Disable that belongs to it comes next.
class RequestQueue {
public:
    void stop() {
        m_request = DeviceRequest::None;
        m_stop = true;
        m_disable = false;
    }
    void stopAndDisable() {
        stop();
        m_disable = true;
    }
    void ask(DeviceRequest request) {
        if (!m_stop)
            m_request = request;
    }
    bool stopDue() const { return m_stop; }
    bool empty() const { return !m_stop && !m_disable && m_request == DeviceRequest::None; }
    /// The one that is due in this cycle.
    DeviceRequest takeNext() {
        if (std::exchange(m_stop, false))
            return DeviceRequest::Stop;
        if (std::exchange(m_disable, false))
            return DeviceRequest::Disable;
        return std::exchange(m_request, DeviceRequest::None);
    }

    // A frame may be lost: Reference and Enable are repeated when they go unanswered, a few times.
    void askToReference() {
        m_referenceTries = kRepeats;
        m_referenceTaken = false;
    }
    void askToEnable() { m_enableTries = kRepeats; }
    void forgetReference() { m_referenceTries = 0; }
    /// It was answered, or its state came: it takes its time now.
    void noteReferenceTaken() { m_referenceTaken = true; }
    bool referenceTaken() const { return m_referenceTaken; }
    /// Whether to repeat the request that was not answered; it is asked for again then.
    bool repeat(DeviceRequest request) {
        int& tries = request == DeviceRequest::Reference ? m_referenceTries : m_enableTries;
        if (tries == 0)
            return false;
        --tries;
        ask(request);
        return true;
    }

private:
    static constexpr int kRepeats = 2;

    DeviceRequest m_request = DeviceRequest::None;
    bool m_stop = false;
    bool m_disable = false;
    int m_referenceTries = 0; ///< left
    int m_enableTries = 0;
    bool m_referenceTaken = false;
};

} // namespace hexapose
