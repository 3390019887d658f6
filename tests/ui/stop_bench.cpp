// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From the key to the STOP frame on the wire: the whole console on a pseudo-terminal, its six charts
// redrawing at 100 Hz of feedback, while a report is being drawn and written all the time.

#include "app/common/device_factory.h"
#include "core/device/simulation/line_controller.h"
#include "core/device/simulation/pseudo_terminal.h"
#include "core/geometry/geometry_file.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/report/error_report.h"
#include "ui/console/report/report_writer.h"
#include "ui/console/window/operator_window.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <poll.h>
#include <random>
#include <thread>
#include <vector>

namespace hexapose {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kStops = 300;
constexpr int kQuietMs = 200; ///< a stop is repeated every 100 ms until it is confirmed: then the next key
constexpr double kAsked = 20.0;
constexpr int kFailed = 1;

/// A controller that notes when the first STOP after a mark arrives.
class StopWatch {
public:
    explicit StopWatch(const PlatformGeometry& geometry)
        : m_controller(VirtualPlatform(geometry)),
          m_thread([this](const std::stop_token& stop) { run(stop); }) {}

    const std::string& path() const { return m_port.path(); }
    void mark() { m_arrived = 0; }
    /// ns of the steady clock; 0: not yet.
    std::int64_t arrived() const { return m_arrived; }

private:
    void run(const std::stop_token& stop) {
        const Clock::time_point start = Clock::now();
        std::array<char, 4096> buffer;
        while (!stop.stop_requested()) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
                start + m_controller.nextDue() - Clock::now());
            pollfd wait{m_port.pollDescriptor(), POLLIN, 0};
            ::poll(&wait, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
            const std::string_view bytes(buffer.data(), m_port.read(buffer));
            const Clock::time_point now = Clock::now();
            std::int64_t none = 0;
            if (bytes.find("$STOP*") != std::string_view::npos)
                m_arrived.compare_exchange_strong(none, now.time_since_epoch().count());
            m_controller.receive(bytes, now - start);
            m_controller.step(Clock::now() - start);
            for (const std::string& frame : m_controller.takeFrames())
                m_port.write(frame);
        }
    }

    PseudoTerminal m_port;
    LineController m_controller;
    std::atomic<std::int64_t> m_arrived{0};
    std::jthread m_thread; ///< last: it ends before what it uses
};

ErrorReport sampleReport(const PlatformGeometry& geometry, const ForwardSolver& solver) {
    std::vector<SettledSample> samples(10);
    for (SettledSample& sample : samples) {
        sample.meanLengths = geometry.homeLengths();
        sample.measurements = 100;
    }
    return makeErrorReport(geometry, solver, samples);
}

void show(std::vector<double> ms) {
    std::sort(ms.begin(), ms.end());
    const auto part = [&](double p) {
        return ms[static_cast<std::size_t>(p * static_cast<double>(ms.size() - 1))];
    };
    std::printf("key to STOP on the wire, %zu stops, six charts and a report being drawn:\n", ms.size());
    std::printf("  median %.1f ms, p90 %.1f ms, p99 %.1f ms, largest %.1f ms (asked: p99 within %.0f ms)\n",
                part(0.5), part(0.9), part(0.99), ms.back(), kAsked);
}

int measure(QApplication& application) {
    const PlatformGeometry geometry =
        loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
    const auto solver = std::make_shared<const NewtonRaphson>(geometry, NewtonOptions{});
    const QTemporaryDir folder;
    StopWatch controller(geometry);
    SessionSetup setup;
    setup.model = makeModel(geometry);
    setup.solver = solver;
    setup.programVersion = "bench";
    setup.logDirectory = folder.path().toStdString();
    OperatorWindow window(setup.model, [] { return QStringList(); });
    window.setSession(std::make_unique<Session>(
        setup, [&](const ConnectionSpec& connection) { return makeDevice(connection, geometry); }));
    window.resize(1280, 800);
    window.show();
    window.connectTo(SerialConnection{controller.path()});

    ReportWriter reports;
    const ErrorReport report = sampleReport(geometry, *solver);
    int reportsDrawn = 0;
    const auto drawAgain = [&] {
        ++reportsDrawn;
        reports.write(report, folder.path() + QStringLiteral("/report"));
    };
    QObject::connect(&reports, &ReportWriter::written, &window, drawAgain);
    drawAgain();

    std::vector<double> latencies;
    std::mt19937 random(1);
    std::uniform_int_distribution<int> pause(kQuietMs, 2 * kQuietMs);
    // The key comes from outside: it waits in the event queue behind whatever the screen is at.
    std::jthread operatorsFinger([&] {
        std::this_thread::sleep_for(std::chrono::seconds(12)); // until the charts are full
        for (int k = 0; k < kStops; ++k) {
            std::this_thread::sleep_for(std::chrono::milliseconds(pause(random)));
            controller.mark();
            const Clock::time_point pressed = Clock::now();
            QMetaObject::invokeMethod(&window, [&window] { QTest::keyClick(&window, Qt::Key_Escape); });
            while (controller.arrived() == 0 && Clock::now() - pressed < std::chrono::seconds(2))
                std::this_thread::sleep_for(std::chrono::microseconds(100));
            const std::int64_t arrived = controller.arrived();
            const std::int64_t since = arrived - pressed.time_since_epoch().count();
            latencies.push_back(arrived == 0 ? 2000.0 : 1e-6 * static_cast<double>(since));
        }
        QMetaObject::invokeMethod(&application, &QCoreApplication::quit, Qt::QueuedConnection);
    });
    application.exec();
    operatorsFinger.join();
    window.disconnectFrom();
    show(latencies);
    std::printf("  reports drawn meanwhile: %d\n", reportsDrawn);
    std::sort(latencies.begin(), latencies.end());
    return latencies[static_cast<std::size_t>(0.99 * (kStops - 1))] <= kAsked ? 0 : kFailed;
}

} // namespace
} // namespace hexapose

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    return hexapose::measure(application);
}
