// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The control loop moves a platform, and logs it, without Qt: 05_drive_a_virtual_platform PLATFORM.toml
//
// The machine is simulated, with a clock of its own, so that this takes no time; every byte of the line
// protocol is passed. For a real one make a LineDevice with a ByteChannel of yours around the port, leave the
// clock out, and give cycle() a thread of its own.

#include <hexapose/core/base/input_error.h>
#include <hexapose/core/base/units.h>
#include <hexapose/core/device/simulation/simulated_machine.h>
#include <hexapose/core/geometry/geometry_file.h>
#include <hexapose/core/kinematics/newton/newton_raphson.h>
#include <hexapose/core/machine/control_loop.h>
#include <hexapose/core/record/event_codec.h>
#include <hexapose/core/record/log_writer.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>

namespace {

using namespace std::chrono_literals;

bool hasEvent(const hexapose::Snapshot& snapshot, hexapose::EventCode code) {
    for (const hexapose::Event& event : snapshot.events)
        if (event.code == code)
            return true;
    return false;
}

} // namespace

int main(int argc, char* argv[]) try {
    if (argc != 2) {
        std::cerr << "usage: 05_drive_a_virtual_platform PLATFORM.toml\n";
        return 2;
    }
    const hexapose::PlatformGeometry platform = hexapose::loadPlatform(argv[1]);
    const hexapose::SharedModel model = hexapose::makeModel(platform); // once, for all who ask it
    const hexapose::NewtonRaphson solver(platform, {});
    hexapose::SimulatedMachine machine(platform);

    const std::filesystem::path file = "drive.csv";
    std::filesystem::remove(file); // a log never overwrites one
    hexapose::LogMetadata metadata;
    metadata.platform = platform;
    metadata.solver = solver.name();
    metadata.port = "simulated";
    hexapose::LogWriter log(file, metadata);

    hexapose::Snapshot now; // of the last cycle
    hexapose::ControlLoop loop(
        machine.device(), model, solver, {},
        [&](const hexapose::Snapshot& snapshot) {
            now = snapshot;
            log.append(snapshot);
            for (const hexapose::Event& event : snapshot.events)
                std::cout << std::chrono::duration<double>(snapshot.time).count()
                          << " s: " << hexapose::formatEvent(event) << '\n';
        },
        machine.clock(),
        std::make_unique<hexapose::ImmediatePlanner>(model)); // no thread beside a simulated clock
    const auto cycleUntil = [&](auto condition) {
        while (!condition() && now.time < 60s)
            loop.cycle();
        return condition();
    };

    // A Run references and enables by itself where that is still due.
    const hexapose::Pose target{{0.012, -0.004, 0.040}, {0.0, 0.0, hexapose::radiansFromDeg(5.0)}};
    if (!cycleUntil([&] { return now.measuredPose.has_value(); }))
        return 1;
    loop.post(hexapose::RunCommand{target, hexapose::MotionMode::Workspace});
    const bool settled = cycleUntil([&] { return hasEvent(now, hexapose::EventCode::Settled); });
    loop.shutDown(); // stop, disable, and wait until that is confirmed
    if (!settled || !now.measuredPose)
        return 1;

    const hexapose::PoseVector error = now.measuredPose->toVector() - target.toVector();
    std::cout << "error, m and rad: " << error.transpose() << "\nlog: " << file << ", " << log.rowCount()
              << " rows\n";
    return error.head<3>().norm() < 2e-4 ? 0 : 1;
} catch (const hexapose::InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
