// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/reconnecting_device.h"

#include "core/device/byte_channel.h"

#include <optional>
#include <thread>

namespace hexapose {

namespace {

constexpr std::chrono::milliseconds kPauseWithoutPort{10};

} // namespace

struct ReconnectingDevice::Impl {
    using Clock = std::chrono::steady_clock;

    Opener opener;
    std::chrono::milliseconds retryEvery;
    std::unique_ptr<PlatformDevice> device;
    DeviceFeedback last; ///< without port: what was known of the controller, and when it was last heard
    LinkCounters before; ///< of the ports that are gone
    Clock::time_point nextTry{};
    bool lossSaid = false;

    void open();
};

void ReconnectingDevice::Impl::open() {
    nextTry = Clock::now() + retryEvery;
    try {
        device = opener();
    } catch (const ChannelError& error) {
        if (!lossSaid)
            last.notices.push_back({DeviceNotice::Kind::LinkLost, {}, error.what()});
        lossSaid = true;
    }
}

ReconnectingDevice::ReconnectingDevice(Opener opener, std::chrono::milliseconds retryEvery)
    : m_impl(std::make_unique<Impl>()) {
    m_impl->opener = std::move(opener);
    m_impl->retryEvery = retryEvery;
}

ReconnectingDevice::~ReconnectingDevice() = default;

DeviceFeedback ReconnectingDevice::exchange(const SetPoints& setPoints) {
    Impl& impl = *m_impl;
    impl.last.notices.clear();
    impl.last.lengths.reset();
    impl.last.link = LinkState::Lost;
    if (!impl.device && Impl::Clock::now() >= impl.nextTry)
        impl.open();
    if (!impl.device) {
        std::this_thread::sleep_for(kPauseWithoutPort); // a port says nothing when it comes back
        return impl.last;
    }
    const auto heardAt = impl.last.receivedAt;
    impl.last = impl.device->exchange(setPoints);
    impl.last.counters += impl.before;
    if (impl.last.receivedAt < heardAt)
        impl.last.receivedAt = heardAt;
    impl.lossSaid = impl.last.link == LinkState::Lost;
    if (impl.lossSaid) {
        impl.device.reset();
        impl.before = impl.last.counters;
        impl.nextTry = Impl::Clock::now() + impl.retryEvery;
    }
    return impl.last;
}

} // namespace hexapose
