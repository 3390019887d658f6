// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Every byte through a real pseudo-terminal and QSerialPort.

#include "core/base/input_error.h"
#include "core/device/line/line_device.h"
#include "core/device/reconnecting_device.h"
#include "core/device/serial/serial_channel.h"
#include "core/device/serial/serial_ports.h"
#include "core/device/simulation/pseudo_terminal.h"
#include "core/device/simulation/virtual_platform_server.h"
#include "tests/core/device/test_platform.h"
#include "tests/support/exchange.h"

#include <QCoreApplication>
#include <QThread>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <thread>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing_support::testPlatform;
namespace fs = std::filesystem;

constexpr int kBaud = 115200;
constexpr int kMaxExchanges = 5000; ///< each at most some 15 ms: a bound for what must happen, not a time

std::atomic<int> warnings{0};
const Interruption none;

class SerialLine : public testing::Test {
protected:
    static void SetUpTestSuite() {
        static int argc = 1;
        static char name[] = "device_test";
        static char* argv[] = {name, nullptr};
        static const QCoreApplication application(argc, argv);
        qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString& text) {
            ++warnings;
            fprintf(stderr, "%s\n", qPrintable(text));
        });
    }
    static void TearDownTestSuite() { qInstallMessageHandler(nullptr); }
    void TearDown() override { EXPECT_EQ(warnings.exchange(0), 0) << "Qt has something to complain about"; }

    static void onThread(const std::function<void()>& work) {
        std::atomic<bool> done{
            false}; // what the thread sanitizer sees of the waiting: Qt's own is hidden from it
        const std::unique_ptr<QThread> thread(QThread::create([&] {
            work();
            done.store(true, std::memory_order_release);
        }));
        thread->start();
        thread->wait();
        EXPECT_TRUE(done.load(std::memory_order_acquire));
    }
    fs::path inFolder(const std::string& name) const {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        const fs::path folder = fs::path(testing::TempDir()) / ("hexapose_" + std::string(test->name()));
        fs::create_directories(folder);
        return folder / name;
    }
};

/// A platform whose watchdog is not what is tried: a busy machine may hold a thread up for longer than 250
/// ms.
VirtualPlatformServerOptions patientPlatform() {
    VirtualPlatformServerOptions options;
    options.platform.watchdog = 10min;
    return options;
}

std::unique_ptr<PlatformDevice> openLine(const std::string& path) {
    return std::make_unique<LineDevice>(std::make_unique<SerialChannel>(path, kBaud));
}

/// Exchanges until the feedback is as wished; the last one.
DeviceFeedback until(PlatformDevice& device, const std::function<bool(const DeviceFeedback&)>& wish,
                     const SetPoints& first = {}, const SetPoints& each = {}) {
    DeviceFeedback feedback = exchange(device, first);
    bool there = wish(feedback);
    for (int i = 0; i < kMaxExchanges && !there; ++i) {
        feedback = exchange(device, each);
        there = wish(feedback);
    }
    EXPECT_TRUE(there);
    return feedback;
}

std::function<bool(const DeviceFeedback&)> inState(ControllerState state) {
    return [state](const DeviceFeedback& f) { return f.link == LinkState::Connected && f.state == state; };
}

/// Connect, reference, enable, go somewhere, stop.
void runThrough(PlatformDevice& device) {
    const auto request = [](DeviceRequest r) { return SetPoints{std::nullopt, r}; };
    until(device, inState(ControllerState::Unreferenced));
    until(device, inState(ControllerState::Disabled), request(DeviceRequest::Reference));
    const SetPoints target{LegLengths::Constant(0.260), DeviceRequest::None};
    until(device, inState(ControllerState::Enabled), request(DeviceRequest::Enable));
    const DeviceFeedback there = until(
        device,
        [](const DeviceFeedback& f) {
            return f.lengths && ((f.lengths->array() - 0.260).abs() < 1e-4).all();
        },
        target, target);
    EXPECT_TRUE(there.acceptedSetPoint);
    EXPECT_TRUE(there.protectedLink);
    until(device, inState(ControllerState::Stopped), request(DeviceRequest::Stop), target);
    until(device, inState(ControllerState::Disabled), request(DeviceRequest::Clear));
}

TEST_F(SerialLine, CarriesAWholeRunOverAPathOrALinkAndOpensAgain) {
    VirtualPlatformServerOptions options = patientPlatform();
    options.link = inFolder("port");
    VirtualPlatformServer server(testPlatform(), options);
    EXPECT_TRUE(server.path().starts_with("/dev/pts/"));
    onThread([&] {
        const std::unique_ptr<PlatformDevice> device = openLine(options.link.string());
        runThrough(*device);
        const DeviceFeedback feedback = exchange(*device, {});
        EXPECT_EQ(feedback.counters.dropped(), 0U);
        EXPECT_EQ(feedback.period, 10ms);
        EXPECT_EQ(feedback.minLength, 0.190);
        EXPECT_THROW(SerialChannel(server.path(), kBaud), ChannelError); // one host at a time
    });
    onThread([&] { // another host later: the platform has gone on
        const std::unique_ptr<PlatformDevice> device = openLine(server.path());
        const DeviceFeedback feedback = until(*device, inState(ControllerState::Disabled));
        EXPECT_EQ(feedback.counters.dropped(), 0U);
    });
}

TEST_F(SerialLine, FaultsOnTheLineAreCountedAndNeverBecomeAMeasurement) {
    VirtualPlatformServerOptions options = patientPlatform();
    options.faults = parseFaultSpec("crc=0.1,drop=0.1,garbage=0.1,nan=0.1,torn=0.1,seed=3");
    const VirtualPlatformServer server(testPlatform(), options);
    const LegLengths home = testPlatform().homeLengths();
    onThread([&] {
        const std::unique_ptr<PlatformDevice> device = openLine(server.path());
        const DeviceFeedback feedback = until(*device, [&](const DeviceFeedback& f) {
            if (f.lengths) {
                EXPECT_LT((*f.lengths - home).cwiseAbs().maxCoeff(), 0.51e-4);
            }
            const LinkCounters& c = f.counters;
            return c.droppedCrc > 0 && c.droppedNumber > 0 && c.droppedLength > 0 && c.droppedGarbage > 0 &&
                   c.missed > 0;
        });
        EXPECT_GT(feedback.counters.accepted, 0U);
    });
}

TEST_F(SerialLine, APortThatGoesIsReportedOnceAndTakenUpAgain) {
    VirtualPlatformServerOptions options = patientPlatform();
    options.link = inFolder("port");
    auto server = std::make_unique<VirtualPlatformServer>(testPlatform(), options);
    onThread([&] {
        ReconnectingDevice device([&] { return openLine(options.link.string()); }, 20ms);
        until(device, inState(ControllerState::Unreferenced));
        server.reset();
        EXPECT_FALSE(fs::exists(fs::symlink_status(options.link)));
        int reported = 0;
        until(device, [&](const DeviceFeedback& f) {
            reported += static_cast<int>(f.notices.size());
            return f.link == LinkState::Lost;
        });
        for (int i = 0; i < 20; ++i)
            reported += static_cast<int>(exchange(device, {}).notices.size());
        EXPECT_EQ(reported, 1);
        server = std::make_unique<VirtualPlatformServer>(testPlatform(), options);
        until(device, inState(ControllerState::Unreferenced));
    });
}

TEST_F(SerialLine, EveryByteArrivesInBothDirections) {
    PseudoTerminal port;
    std::string all;
    for (int i = 0; i < 3 * 256; ++i)
        all += static_cast<char>(i);
    onThread([&] {
        SerialChannel channel(port.path(), kBaud);
        ASSERT_EQ(port.write(all), all.size());
        std::array<char, 100> buffer;
        std::string read;
        for (int i = 0; i < kMaxExchanges && read.size() < all.size(); ++i)
            read.append(buffer.data(), channel.read(buffer, 15ms, none));
        EXPECT_EQ(read, all);
        channel.write(all);
        std::string written;
        while (written.size() < all.size()) {
            pollfd wait{port.pollDescriptor(), POLLIN, 0};
            ASSERT_EQ(poll(&wait, 1, 10000), 1);
            written.append(buffer.data(), port.read(buffer));
        }
        EXPECT_EQ(written, all);
    });
}

TEST_F(SerialLine, WhatCameBeforeTheOpeningIsNotRead) {
    PseudoTerminal port;
    const std::string old = line::frame("LEN,1,1,1,1,1,1,1,1,E,-1");
    while (port.write(old) == old.size()) { // until nobody takes any more: the writer is never blocked
    }
    onThread([&] {
        SerialChannel channel(port.path(), kBaud);
        std::array<char, 4096> buffer;
        EXPECT_EQ(channel.read(buffer, 1ms, none), 0U);
        ASSERT_EQ(port.write("new"), 3U);
        const std::size_t count = channel.read(buffer, 10s, none);
        EXPECT_EQ(std::string(buffer.data(), count), "new");
    });
}

TEST_F(SerialLine, AStopComesLastWholeAndBehindNoMoreThanWasWritten) {
    PseudoTerminal port;
    onThread([&] {
        SerialChannel channel(port.path(), kBaud);
        channel.write(std::string(1000, 'x'));
        channel.dropUnsent(); // the system decides how much of it has left already
        channel.write("STOP");
        std::array<char, 4096> buffer;
        std::string arrived;
        while (!arrived.ends_with("STOP")) {
            pollfd wait{port.pollDescriptor(), POLLIN, 0};
            ASSERT_EQ(poll(&wait, 1, 10000), 1) << arrived;
            arrived.append(buffer.data(), port.read(buffer));
        }
        EXPECT_LE(arrived.size(), 1004U);
        EXPECT_EQ(channel.unsent(), 0U);
    });
}

TEST_F(SerialLine, AnInterruptionEndsTheWaitForBytes) {
    PseudoTerminal port;
    onThread([&] {
        LineDeviceOptions options;
        options.longestWait = 1h;
        LineDevice device(std::make_unique<SerialChannel>(port.path(), kBaud), options);
        device.interrupt(); // before the wait, and in it
        EXPECT_FALSE(device.read().lengths);
        std::atomic<bool> ended{false};
        std::thread other([&] {
            while (!ended)
                device.interrupt();
        });
        EXPECT_FALSE(device.read().lengths);
        ended = true;
        other.join();
    });
}

TEST_F(SerialLine, BytesThatCameBeforeThePortWentAreRead) {
    std::array<char, 4096> buffer;
    onThread([&] {
        auto port = std::make_unique<PseudoTerminal>();
        SerialChannel channel(port->path(), kBaud);
        ASSERT_EQ(port->write("last"), 4U);
        const std::size_t count = channel.read(buffer, 10s, none);
        EXPECT_EQ(std::string(buffer.data(), count), "last");
        port.reset();
        EXPECT_THROW(channel.read(buffer, 10s, none), ChannelError);
        EXPECT_THROW(channel.read(buffer, 0ms, none), ChannelError);
        EXPECT_THROW(channel.write("x"), ChannelError);
    });
}

TEST_F(SerialLine, AControllerThatTakesNothingIsALostPortNotAHang) {
    PseudoTerminal port;
    onThread([&] {
        SerialChannel channel(port.path(), kBaud);
        EXPECT_THROW(
            {
                for (int i = 0; i < kMaxExchanges; ++i)
                    channel.write(std::string(4096, 'x'));
            },
            ChannelError);
    });
}

TEST_F(SerialLine, SaysWhyAPortCannotBeOpened) {
    const fs::path file = inFolder("file");
    std::ofstream(file) << "text";
    const std::pair<std::string, const char*> rows[] = {{"/dev/no_such_port", "No such file"},
                                                        {file.string(), "not a serial port"},
                                                        {"/dev/null", "not opened as a serial port"},
                                                        {"", "Invalid argument"}};
    for (const auto& [path, reason] : rows) {
        try {
            const SerialChannel channel(path, kBaud);
            ADD_FAILURE() << path;
        } catch (const ChannelError& error) {
            EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
            EXPECT_TRUE(std::string(error.what()).starts_with(path));
        }
    }
    for (const SerialPortInfo& port : listSerialPorts())
        EXPECT_TRUE(port.path.starts_with("/dev/")) << port.path;
}

TEST_F(SerialLine, ALinkNeverReplacesAFile) {
    const fs::path file = inFolder("file");
    std::ofstream(file) << "text";
    EXPECT_THROW(PseudoTerminal{file}, InputError);
    EXPECT_TRUE(fs::is_regular_file(file));
    EXPECT_THROW(PseudoTerminal{inFolder("absent") / "link"}, InputError);
    const fs::path link = inFolder("link");
    fs::remove(link);
    fs::create_symlink("/nowhere", link);
    {
        const PseudoTerminal port(link); // a dangling link of an earlier run
        EXPECT_EQ(fs::read_symlink(link), port.path());
    }
    EXPECT_FALSE(fs::exists(fs::symlink_status(link)));
}

} // namespace
} // namespace hexapose
