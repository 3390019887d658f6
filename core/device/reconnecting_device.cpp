// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/reconnecting_device.h"

#include "core/device/byte_channel.h"
#include "core/device/interruption.h"

#include <mutex>
#include <utility>

namespace hexapose {

namespace {

constexpr std::chrono::milliseconds kPauseWithoutPort{10}; ///< a port gives no sign when it comes back

} // namespace

struct ReconnectingDevice::Impl {
    using Clock = std::chrono::steady_clock;

    Opener opener;
    std::chrono::milliseconds retryEvery;
    std::unique_ptr<PlatformDevice> device;
    DeviceFeedback last; ///< without port: what was known of the controller, and when it was last heard
    LinkCounters before; ///< of the ports that are gone
    Clock::time_point nextTry{};
    bool lossReported = false;
    Interruption interruption; ///< where there is no port
    std::mutex mutex;          ///< guards the pointer to the device against interrupt()

    void open();
};

void ReconnectingDevice::Impl::open() {
    nextTry = Clock::now() + retryEvery;
    try {
        std::unique_ptr<PlatformDevice> opened = opener();
        const std::lock_guard lock(mutex);
        device = std::move(opened);
    } catch (const ChannelError& error) {
        if (!lossReported)
            last.notices.push_back(notice::LinkLost{error.failure()});
        lossReported = true;
    }
}

ReconnectingDevice::ReconnectingDevice(Opener opener, std::chrono::milliseconds retryEvery)
    : m_impl(std::make_unique<Impl>()) {
    m_impl->opener = std::move(opener);
    m_impl->retryEvery = retryEvery;
}

ReconnectingDevice::~ReconnectingDevice() = default;

const DeviceFeedback& ReconnectingDevice::read() {
    Impl& impl = *m_impl;
    impl.last.notices.clear();
    impl.last.lengths.reset();
    impl.last.roundTrip.reset();
    impl.last.link = LinkState::Lost;
    if (!impl.device && Impl::Clock::now() >= impl.nextTry)
        impl.open();
    if (!impl.device) {
        impl.interruption.wait(kPauseWithoutPort);
        return impl.last;
    }
    const auto heardAt = impl.last.receivedAt;
    impl.last = impl.device->read();
    impl.last.counters += impl.before;
    if (impl.last.receivedAt < heardAt)
        impl.last.receivedAt = heardAt;
    impl.lossReported = impl.last.link == LinkState::Lost;
    if (impl.lossReported) {
        {
            const std::lock_guard lock(impl.mutex);
            impl.device.reset();
        }
        impl.before = impl.last.counters;
        impl.nextTry = Impl::Clock::now() + impl.retryEvery;
    }
    return impl.last;
}

void ReconnectingDevice::write(const SetPoints& setPoints) {
    if (m_impl->device)
        m_impl->device->write(setPoints);
}

void ReconnectingDevice::interrupt() {
    m_impl->interruption.request();
    const std::lock_guard lock(m_impl->mutex);
    if (m_impl->device)
        m_impl->device->interrupt();
}

} // namespace hexapose
