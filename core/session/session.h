// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/thread_priority.h"
#include "core/kinematics/forward_solver.h"
#include "core/kinematics/platform_model.h"
#include "core/machine/command.h"
#include "core/machine/control_loop.h"
#include "core/record/log_options.h"
#include "core/session/connection.h"
#include "core/session/snapshot_ring.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace hexapose {

class PlatformDevice;

/// What a session works with; fixed while it is open, except for the solver.
struct SessionSetup {
    SharedModel model; ///< of all who work with this session: its loop, and the screen
    std::shared_ptr<const ForwardSolver> solver;
    std::string modelFingerprint;
    std::string programVersion;
    std::filesystem::path logDirectory; ///< for logs that are named after the time
    ControlOptions control;
    LogOptions log;
};

/// What the system granted the present or last connection.
struct SessionInfo {
    std::filesystem::path logFile;
    std::optional<ThreadPriority> priority; ///< of the loop's thread; empty until it runs
    bool memoryLocked = false;
};

/// Owns the loop's thread and the session log. Nobody waits for the loop: commands are posted, snapshots are
/// read from a ring. One thread opens, closes and sets; post() and reader() may be called from any.
class Session {
public:
    /// Called on the loop's thread; the device it returns lives and ends there.
    using DeviceFactory = std::function<std::unique_ptr<PlatformDevice>(const ConnectionSpec&)>;

    Session(SessionSetup setup, DeviceFactory factory);
    ~Session(); ///< as close()
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    const SessionSetup& setup() const;
    /// While open, the loop takes it between two cycles, as soon as nothing moves, and reports it as an
    /// event.
    void setSolver(std::shared_ptr<const ForwardSolver> solver, const std::string& modelFingerprint);
    /// The one in use.
    std::shared_ptr<const ForwardSolver> solver() const;

    /// Starts the loop's thread and a new log in the log directory. Failure to open the port is reported as
    /// an event, and tried again. Throws InputError when the log cannot be created.
    void open(const ConnectionSpec& connection);
    /// The same with this log, which must not exist.
    void open(const ConnectionSpec& connection, const std::filesystem::path& logFile);
    /// Stops motion, disables, closes the port, completes the log.
    void close();
    bool isOpen() const;
    /// Without effect while closed.
    void post(const OperatorCommand& command);

    /// Begins with the oldest cycle that is kept, and goes on through later connections.
    SnapshotReader reader() const;
    SessionInfo info() const;
    /// Of the present or last connection, its first part; empty before the first connection.
    std::filesystem::path logFile() const;
    /// Why the log of the present or last connection is not complete.
    std::optional<LogFailure> logFailure() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace hexapose
