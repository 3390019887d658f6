// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/file_descriptor.h"
#include "core/device/simulation/fault_injector.h"
#include "core/device/simulation/line_controller.h"
#include "core/device/simulation/pseudo_terminal.h"
#include "core/device/simulation/virtual_platform.h"
#include "core/geometry/platform_geometry.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

namespace hexapose {

struct VirtualPlatformServerOptions {
    std::filesystem::path link; ///< symbolic link to the port; empty: none
    LineControllerOptions controller;
    VirtualPlatformOptions platform;
    std::optional<FaultSpec> faults; ///< their noise replaces the platform's
};

/// The virtual platform on a pseudo-terminal, in a thread of its own, for as long as it lives. Prints
/// nothing.
class VirtualPlatformServer {
public:
    /// Throws ChannelError or InputError, as PseudoTerminal does.
    explicit VirtualPlatformServer(const PlatformGeometry& geometry,
                                   const VirtualPlatformServerOptions& options = {});
    ~VirtualPlatformServer();

    const std::string& path() const { return m_port.path(); } ///< "/dev/pts/7"

private:
    void run(const std::stop_token& stop);
    void waitForWork(std::chrono::steady_clock::time_point until);
    void readPort(std::chrono::nanoseconds now);
    void writePort(std::chrono::nanoseconds now);

    PseudoTerminal m_port;
    LineController m_controller;
    std::optional<FaultInjector> m_faults;
    std::string m_unsent; ///< rest of a frame that the port took only in part
    FileDescriptor m_wake;
    std::jthread m_thread; ///< last: it ends before what it uses
};

} // namespace hexapose
