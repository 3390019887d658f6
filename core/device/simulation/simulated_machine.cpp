// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/simulation/simulated_machine.h"

#include "core/device/byte_channel.h"
#include "core/device/line/line_device.h"
#include "core/device/simulation/line_controller.h"

#include <algorithm>
#include <string>

namespace hexapose {

using namespace std::chrono_literals;

struct SimulatedMachine::Impl {
    Impl(const PlatformGeometry& geometry, const VirtualPlatformOptions& options,
         std::chrono::milliseconds period)
        : controller(VirtualPlatform(geometry, options), {"Hexapose simulated machine", period}) {}

    void advance(std::chrono::nanoseconds until) {
        now = std::max(now, until);
        controller.step(now);
        for (const std::string& frame : controller.takeFrames())
            toHost += frame;
    }

    LineController controller;
    std::chrono::nanoseconds now{0};
    std::string toHost;
    std::unique_ptr<LineDevice> device;
};

namespace {

/// The wire: what is written arrives at once, and waiting moves the clock.
template <class Machine>
class Wire final : public ByteChannel {
public:
    explicit Wire(Machine& machine) : m_machine(machine) {}
    std::size_t read(std::span<char> buffer, std::chrono::milliseconds wait,
                     const Interruption& interruption) override {
        const std::chrono::nanoseconds until = m_machine.now + (interruption.requested() ? 0ms : wait);
        while (m_machine.toHost.empty() && m_machine.now < until)
            m_machine.advance(std::min<std::chrono::nanoseconds>(m_machine.controller.nextDue(), until));
        const std::size_t count = std::min(buffer.size(), m_machine.toHost.size());
        std::copy_n(m_machine.toHost.begin(), count, buffer.begin());
        m_machine.toHost.erase(0, count);
        return count;
    }
    void write(std::string_view bytes) override { m_machine.controller.receive(bytes, m_machine.now); }

private:
    Machine& m_machine;
};

} // namespace

SimulatedMachine::SimulatedMachine(const PlatformGeometry& geometry, const VirtualPlatformOptions& options,
                                   std::chrono::milliseconds period)
    : m_impl(std::make_shared<Impl>(geometry, options, period)) {
    LineDeviceOptions device;
    device.desiredPeriod = period;
    device.now = clock();
    m_impl->device = std::make_unique<LineDevice>(std::make_unique<Wire<Impl>>(*m_impl), device);
}

SimulatedMachine::~SimulatedMachine() {
    m_impl->device.reset(); // it refers to the rest
}

PlatformDevice& SimulatedMachine::device() {
    return *m_impl->device;
}

std::function<std::chrono::steady_clock::time_point()> SimulatedMachine::clock() const {
    return [impl = m_impl.get()] { return std::chrono::steady_clock::time_point(impl->now); };
}

LegLengths SimulatedMachine::trueLengths() const {
    return m_impl->controller.platform().lengths();
}

void SimulatedMachine::push(int leg, double offset) {
    m_impl->controller.push(leg, offset);
}

} // namespace hexapose
