// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The control loop on pseudo-terminals: the processor time of a cycle by phase, and how long a STOP takes
// from the bad measurement that causes it.

#include "core/base/thread_priority.h"
#include "core/device/line/line_codec.h"
#include "core/device/line/line_device.h"
#include "core/device/serial/serial_channel.h"
#include "core/device/simulation/virtual_platform_server.h"
#include "core/geometry/geometry_file.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/machine/control_loop.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <poll.h>
#include <random>
#include <thread>
#include <vector>

namespace {

using namespace hexapose;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int kBaud = 115200;
constexpr int kCycles = 12000;
constexpr int kStops = 200;
constexpr std::array<const char*, 6> kPhaseNames{"read",     "estimate", "supervise",
                                                 "generate", "write",    "publish"};

double threadCpuMs() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double quantile(std::vector<double>& values, double part) {
    if (values.empty())
        return 0.0;
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Processor time of each phase, of all but the read, in which the wire is waited for, and of the whole
/// cycle.
class PhaseClock final : public CycleObserver {
public:
    void onPhase(CyclePhase begins) override {
        const double now = threadCpuMs();
        if (m_phase != CyclePhase::End && begins != CyclePhase::Read)
            times[static_cast<std::size_t>(m_phase)].push_back(now - m_since);
        if (begins == CyclePhase::Read)
            m_cycle = now;
        if (begins == CyclePhase::Estimate)
            m_afterRead = now;
        if (begins == CyclePhase::End) {
            afterRead.push_back(now - m_afterRead);
            whole.push_back(now - m_cycle);
        }
        m_phase = begins;
        m_since = now;
    }
    std::array<std::vector<double>, 6> times;
    std::vector<double> afterRead;
    std::vector<double> whole;

private:
    CyclePhase m_phase = CyclePhase::End;
    double m_since = 0.0;
    double m_cycle = 0.0;
    double m_afterRead = 0.0;
};

void printRow(const char* name, std::vector<double>& ms) {
    std::printf("  %-28s %8.1f %8.1f %8.1f %8.1f\n", name, 1e3 * quantile(ms, 0.5), 1e3 * quantile(ms, 0.99),
                1e3 * quantile(ms, 0.999), 1e3 * quantile(ms, 1.0));
}

/// Moves to and fro in both modes on the virtual platform, feedback each millisecond.
void benchPhases(const PlatformGeometry& geometry, const ForwardSolver& solver) {
    VirtualPlatformServerOptions options;
    options.platform.watchdog = 10min; // a busy machine may hold a thread up
    VirtualPlatformServer server(geometry, options);
    LineDeviceOptions line;
    line.desiredPeriod = 1ms;
    LineDevice device(std::make_unique<SerialChannel>(server.path(), kBaud), line);
    Snapshot last;
    ControlLoop loop(device, makeModel(geometry), solver, {}, [&](const Snapshot& s) { last = s; });
    PhaseClock clock;
    loop.setObserver(&clock);
    const std::array<Pose, 2> targets{Pose{{0.012, -0.004, 0.030}, {0.0, 0.0, 0.08}},
                                      Pose{{-0.01, 0.01, -0.01}, {}}};
    int moves = 0;
    for (int cycle = 0; cycle < kCycles; ++cycle) {
        if (last.allowed.contains(Command::Run) && last.measuredPose && cycle % 500 == 0) {
            const MotionMode mode = moves % 2 == 0 ? MotionMode::Workspace : MotionMode::Joint;
            loop.post(RunCommand{targets[static_cast<std::size_t>(moves / 2 % 2)], mode});
            ++moves;
        }
        loop.cycle();
    }
    std::printf("processor time of a cycle of the loop, us (%d cycles, %d moves asked for)\n", kCycles,
                moves);
    std::printf("  %-28s %8s %8s %8s %8s\n", "phase", "median", "p99", "p99.9", "largest");
    for (std::size_t phase = 0; phase < kPhaseNames.size(); ++phase)
        printRow(kPhaseNames[phase], clock.times[phase]);
    printRow("all but read", clock.afterRead);
    printRow("whole cycle", clock.whole);
    loop.setObserver(nullptr);
    loop.shutDown();
}

/// A controller that follows at once, and now and then reports a leg far from its set-point.
class BadController {
public:
    explicit BadController(const PlatformGeometry& geometry)
        : m_home(geometry.homeLengths()), m_thread([this](const std::stop_token& stop) { run(stop); }) {}
    const std::string& path() const { return m_port.path(); }
    void misbehave() { m_bad = true; }
    std::vector<double> latenciesMs() {
        m_thread.request_stop();
        m_thread.join();
        return m_latencies;
    }
    int stops() const { return m_stops; }

private:
    void say(const line::LineMessage& message) { m_port.write(line::encode(message)); }
    void run(const std::stop_token& stop) {
        line::FrameReader reader(line::Side::Controller);
        std::array<char, 4096> buffer{};
        std::vector<line::LineMessage> messages;
        LegLengths lengths = m_home;
        ControllerState state = ControllerState::Disabled;
        std::int32_t set = -1;
        std::uint16_t number = 0;
        Clock::time_point due = Clock::now(), badAt{};
        const Clock::time_point begin = due;
        while (!stop.stop_requested()) {
            pollfd wait{m_port.pollDescriptor(), POLLIN, 0};
            const auto left =
                std::chrono::duration_cast<std::chrono::milliseconds>(due - Clock::now()).count();
            ::poll(&wait, 1, static_cast<int>(std::clamp<long long>(left, 0, 10)));
            messages.clear();
            reader.feed({buffer.data(), m_port.read(buffer)}, messages);
            for (const line::LineMessage& message : messages) {
                if (std::holds_alternative<line::Hello>(message))
                    say(line::Ident{"bench", 10ms, 0.1, 1.0});
                if (std::holds_alternative<line::Period>(message))
                    say(line::Ok{"PERIOD"});
                if (const auto* setPoint = std::get_if<line::Set>(&message)) {
                    lengths = setPoint->lengths;
                    set = setPoint->number;
                }
                if (std::holds_alternative<line::Enable>(message)) {
                    state = ControllerState::Enabled;
                    say(line::Ok{"ENABLE"});
                }
                if (std::holds_alternative<line::Disable>(message))
                    say(line::Ok{"DISABLE"});
                if (std::holds_alternative<line::Clear>(message)) {
                    state = ControllerState::Disabled;
                    say(line::Ok{"CLEAR"});
                }
                if (std::holds_alternative<line::Stop>(message)) {
                    if (badAt != Clock::time_point{})
                        m_latencies.push_back(
                            std::chrono::duration<double, std::milli>(Clock::now() - badAt).count());
                    badAt = {};
                    state = ControllerState::Stopped;
                    say(line::Ok{"STOP"});
                    ++m_stops;
                }
            }
            if (Clock::now() < due)
                continue;
            due += 10ms;
            LegLengths reported = lengths;
            const bool bad = state == ControllerState::Enabled && m_bad.exchange(false);
            if (bad) {
                reported[2] += 0.05;
                badAt = Clock::now();
            }
            say(line::Len{number++,
                          std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin),
                          reported, state, set});
        }
    }

    PseudoTerminal m_port;
    LegLengths m_home;
    std::atomic<bool> m_bad{false};
    std::atomic<int> m_stops{0};
    std::vector<double> m_latencies;
    std::jthread m_thread; ///< last: it ends before what it uses
};

void benchStop(const PlatformGeometry& geometry, const ForwardSolver& solver) {
    BadController controller(geometry);
    LineDevice device(std::make_unique<SerialChannel>(controller.path(), kBaud));
    Snapshot last;
    ControlLoop loop(device, makeModel(geometry), solver, {}, [&](const Snapshot& s) { last = s; });
    const auto cycleUntil = [&](RunState state) {
        for (int cycle = 0; cycle < 1000 && last.state != state; ++cycle)
            loop.cycle();
    };
    std::mt19937 random(1);
    for (int stop = 0; stop < kStops; ++stop) {
        cycleUntil(RunState::Disabled);
        loop.post(RunCommand{Pose{{0.0, 0.0, stop % 2 == 0 ? 0.02 : 0.0}, {}}, MotionMode::Joint});
        cycleUntil(RunState::Moving);
        for (unsigned cycle = 0; cycle < 5 + random() % 10; ++cycle)
            loop.cycle();
        controller.misbehave();
        cycleUntil(RunState::Stopped);
        for (int cycle = 0; cycle < 5; ++cycle)
            loop.cycle();
        loop.post(ClearCommand{});
    }
    loop.shutDown();
    std::vector<double> ms = controller.latenciesMs();
    std::printf("bad measurement in to STOP out on a pseudo-terminal, us (%zu stops)\n", ms.size());
    std::printf("  %-28s %8s %8s %8s %8s\n", "", "median", "p99", "p99.9", "largest");
    printRow("controller to controller", ms);
}

} // namespace

int main(int argc, char* argv[]) {
    const QCoreApplication application(argc, argv);
    raiseThreadPriority();
    const PlatformGeometry geometry =
        loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
    const NewtonRaphson solver(geometry, {});
    benchPhases(geometry, solver);
    benchStop(geometry, solver);
}
