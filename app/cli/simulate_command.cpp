// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/common/arguments.h"
#include "core/base/input_error.h"
#include "core/base/units.h"
#include "core/device/byte_channel.h"
#include "core/device/simulation/virtual_platform_server.h"

#include <csignal>
#include <cstdio>

namespace hexapose {

namespace {

/// Blocked before any thread starts, so that every thread inherits it and the main one can wait for them.
sigset_t blockEndSignals() {
    sigset_t endSignals;
    sigemptyset(&endSignals);
    sigaddset(&endSignals, SIGINT);
    sigaddset(&endSignals, SIGTERM);
    sigaddset(&endSignals, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &endSignals, nullptr);
    return endSignals;
}

} // namespace

Usage simulateUsage() {
    return {"hexapose-cli simulate",
            {},
            {{"protocol", "line", "Protocol to speak."},
             {"link", "PATH", "A symbolic link to make to the port."},
             {"period-ms", "P", "Feedback period, 1 to 1000 ms (default: 10)."},
             {"resolution-mm", "R", "Resolution of the measured lengths (default: 0.1)."},
             {"faults", "SPEC",
              "What goes wrong, for example crc=0.01,drop=0.02,garbage=0.01,"
              "nan=0.01,torn=0.02,silence=10@5,noise=0.05,seed=7."}}};
}

int simulateCommand(const Arguments& arguments) {
    const std::string protocol = arguments.requiredText("protocol");
    if (protocol != "line")
        throw InputError("--protocol",
                         "'" + protocol + "' is not available in this version (available: line)");
    VirtualPlatformServerOptions options;
    if (arguments.has("link"))
        options.link = arguments.requiredText("link");
    options.controller.period = std::chrono::milliseconds(arguments.integer("period-ms", 10, 1, 1000));
    options.platform.resolution = metresFromMm(arguments.positive("resolution-mm", 0.1));
    if (arguments.has("faults"))
        options.faults = parseFaultSpec(arguments.requiredText("faults"));
    const PlatformGeometry platform = arguments.platform();

    const sigset_t endSignals = blockEndSignals();
    try {
        const VirtualPlatformServer server(platform, options);
        std::printf("%s\n", server.path().c_str());
        std::fflush(stdout);
        int received = 0;
        sigwait(&endSignals, &received);
    } catch (const ChannelError& error) {
        throw InputError("simulate", error.what());
    }
    return kExitDone;
}

} // namespace hexapose
