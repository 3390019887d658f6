// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/common/device_factory.h"

#include "core/device/line/line_device.h"
#include "core/device/reconnecting_device.h"
#include "core/device/serial/serial_channel.h"
#include "core/device/simulation/virtual_platform_server.h"

#include <algorithm>
#include <variant>

namespace hexapose {

namespace {

constexpr int kVirtualBaud = 115200;

/// The shortest period, in steps of 10 ms, in which a slow line carries a frame each way without falling
/// behind.
std::chrono::milliseconds feedbackPeriod(int baud) {
    constexpr int kBitsOfFrame = 110 * 10; ///< lengths with six decimals; start and stop bit a byte
    constexpr int kStepMs = 10;
    const int ms = 1000 * kBitsOfFrame / std::max(baud, 1);
    return std::chrono::milliseconds(std::min((ms / kStepMs + 1) * kStepMs, 1000));
}

/// The virtual platform and the port to it: one lives as long as the other.
class VirtualDevice final : public PlatformDevice {
public:
    explicit VirtualDevice(const PlatformGeometry& geometry)
        : m_server(geometry), m_device(makeSerialDevice(m_server.path(), kVirtualBaud)) {}
    const DeviceFeedback& read() override { return m_device->read(); }
    void write(const SetPoints& setPoints) override { m_device->write(setPoints); }
    void interrupt() override { m_device->interrupt(); }

private:
    VirtualPlatformServer m_server;
    std::unique_ptr<PlatformDevice> m_device;
};

/// One function a kind of connection: a kind without one does not compile.
struct DeviceOf {
    const PlatformGeometry& geometry;
    std::unique_ptr<PlatformDevice> operator()(const VirtualConnection&) const {
        return makeVirtualDevice(geometry);
    }
    std::unique_ptr<PlatformDevice> operator()(const SerialConnection& serial) const {
        return makeSerialDevice(serial.path, serial.baud);
    }
};

} // namespace

std::unique_ptr<PlatformDevice> makeSerialDevice(const std::string& portPath, int baud) {
    LineDeviceOptions options;
    options.desiredPeriod = feedbackPeriod(baud);
    return std::make_unique<ReconnectingDevice>([portPath, baud, options] {
        return std::make_unique<LineDevice>(std::make_unique<SerialChannel>(portPath, baud), options);
    });
}

std::unique_ptr<PlatformDevice> makeVirtualDevice(const PlatformGeometry& geometry) {
    return std::make_unique<VirtualDevice>(geometry);
}

std::unique_ptr<PlatformDevice> makeDevice(const ConnectionSpec& connection,
                                           const PlatformGeometry& geometry) {
    return std::visit(DeviceOf{geometry}, connection);
}

} // namespace hexapose
