// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device/platform_device.h"
#include "core/geometry/platform_geometry.h"
#include "core/kinematics/forward_solver.h"
#include "core/machine/command.h"
#include "core/machine/control_loop.h"
#include "core/record/snapshot.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace hexapose {

/// Where to connect: the built-in virtual platform, or a serial port.
struct ConnectionChoice {
    bool virtualPlatform = true;
    QString port; ///< path; unused for the virtual platform
    int baud = 115200;
};

/// What a session works with; but for the solver fixed while it is open.
struct SessionSetup {
    PlatformGeometry geometry;
    std::shared_ptr<const ForwardSolver> solver;
    std::string modelFingerprint;
    std::string programVersion;
    std::filesystem::path logDirectory;
    ControlOptions control;
};

/// Owns the loop's thread and the session log. The screen polls takeSnapshots() on its display tick and never
/// waits for the loop. All members are called on the screen's thread.
class Session final : public QObject {
    Q_OBJECT
public:
    /// Called on the loop's thread; the device it returns lives and dies there.
    using DeviceFactory = std::function<std::unique_ptr<PlatformDevice>(const ConnectionChoice&)>;

    Session(SessionSetup setup, DeviceFactory factory, QObject* parent = nullptr);
    ~Session() override; ///< as close()

    const SessionSetup& setup() const;
    /// While open, the loop takes it between two cycles, as soon as nothing moves, and says so by an event.
    void setSolver(std::shared_ptr<const ForwardSolver> solver, const std::string& modelFingerprint);
    /// The one in use.
    std::shared_ptr<const ForwardSolver> solver() const;
    /// Starts the loop's thread and a new log. A port that cannot be opened is told by an event, and tried
    /// again. Throws InputError when the log cannot be created.
    void open(const ConnectionChoice& choice);
    /// Stops motion, disables, closes the port, ends the log.
    void close();
    bool isOpen() const;
    void post(const OperatorCommand& command);

    /// Every cycle since the last call, oldest first (at most the last 30 s).
    std::vector<Snapshot> takeSnapshots();
    /// Of the present or last session; empty before the first.
    QString logFile() const;
    std::optional<std::string> logFailure() const;

signals:
    void opened();
    void closed();

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace hexapose
