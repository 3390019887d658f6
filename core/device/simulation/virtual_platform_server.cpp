// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/simulation/virtual_platform_server.h"

#include "core/device/byte_channel.h"

#include <poll.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <array>
#include <ctime>

namespace hexapose {

namespace {

using Steady = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLatest{100};
constexpr std::chrono::seconds kUnlockEvery{1};

VirtualPlatform makePlatform(const PlatformGeometry& geometry, const VirtualPlatformServerOptions& options) {
    VirtualPlatformOptions platform = options.platform;
    if (options.faults) {
        platform.noise = options.faults->noise;
        platform.seed = options.faults->seed;
    }
    return VirtualPlatform(geometry, platform);
}

} // namespace

VirtualPlatformServer::VirtualPlatformServer(const PlatformGeometry& geometry,
                                             const VirtualPlatformServerOptions& options)
    : m_port(options.link), m_controller(makePlatform(geometry, options), options.controller),
      m_wake(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    if (m_wake.get() < 0)
        throw ChannelError("no event descriptor left");
    if (options.faults)
        m_faults.emplace(*options.faults);
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

VirtualPlatformServer::~VirtualPlatformServer() {
    m_thread.request_stop();
    ::eventfd_write(m_wake.get(), 1);
}

void VirtualPlatformServer::run(const std::stop_token& stop) {
    Steady::time_point start = Steady::now();
    Steady::time_point nextUnlock = start;
    try {
        while (!stop.stop_requested()) {
            const Steady::time_point due = start + m_controller.nextDue();
            waitForWork(due);
            const Steady::time_point time = Steady::now();
            // The controller's clock stands still while a busy machine holds this thread up: its watchdog is
            // for a host that is silent.
            if (time - due > kLatest)
                start += time - due - kLatest;
            if (time >= nextUnlock) {
                m_port.unlock();
                nextUnlock = time + kUnlockEvery;
            }
            readPort(time - start);
            m_controller.step(time - start);
            writePort(time - start);
        }
    } catch (const ChannelError&) {
        // The system took the port away: hosts see that for themselves.
    }
}

void VirtualPlatformServer::waitForWork(Steady::time_point until) {
    const auto left = std::max(until - Steady::now(), Steady::duration::zero());
    const auto seconds = std::chrono::floor<std::chrono::seconds>(left);
    const timespec timeout{seconds.count(), (left - seconds).count()};
    std::array<pollfd, 2> waits{{{m_port.pollDescriptor(), POLLIN, 0}, {m_wake.get(), POLLIN, 0}}};
    ::ppoll(waits.data(), waits.size(), &timeout, nullptr);
}

void VirtualPlatformServer::readPort(std::chrono::nanoseconds now) {
    std::array<char, 4096> buffer;
    const std::size_t count = m_port.read(buffer);
    if (count > 0)
        m_controller.receive({buffer.data(), count}, now);
}

void VirtualPlatformServer::writePort(std::chrono::nanoseconds now) {
    m_unsent.erase(0, m_port.write(m_unsent));
    for (const std::string& frame : m_controller.takeFrames()) {
        const std::string bytes = m_faults ? m_faults->apply(frame, now) : frame;
        if (m_unsent.empty()) // otherwise nobody reads: what is new is lost, as on a real line
            m_unsent = bytes.substr(m_port.write(bytes));
    }
}

} // namespace hexapose
