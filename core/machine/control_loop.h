// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"
#include "core/geometry/platform_geometry.h"
#include "core/kinematics/forward_solver.h"
#include "core/machine/command.h"
#include "core/motion/limits.h"
#include "core/record/snapshot.h"
#include "core/tracking/motion_generator.h"

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace hexapose {

struct ControlOptions {
    MotionBounds bounds;   ///< what is 0 is filled in from the machine
    double gain = 8.0;     ///< 1/s, of the loop that is closed on the pose
    PoseEnvelope envelope; ///< no further from home
    /// Largest error that counts as there; 0: 0.2 mm, less for tiny strokes, and as much at the joints.
    SettleWindow settleWindow;
    double followingLimit = 0.0; ///< m, a leg further than this from its set-point stops; 0: of the size
    std::chrono::milliseconds echoWithin{300}; ///< set-points unaccepted for so long stop
    std::chrono::milliseconds longestPathStep{
        30};                                ///< of the path's time in a cycle; ordinary ones take 15 at most
    std::chrono::milliseconds jogHold{200}; ///< a jog that is not said again within comes to rest
    std::chrono::milliseconds settleTime{300}; ///< inside the window for so long
    std::chrono::milliseconds settleTimeout{10000};
    std::chrono::milliseconds staleAfter{200};     ///< at least; three feedback periods when those are longer
    std::chrono::milliseconds enableTimeout{5000}; ///< for the enabling before a move
    std::chrono::milliseconds referenceTimeout{120000}; ///< for the referencing before a move
};

/// What is not given, filled in from the machine: the bounds, the settle window, the following limit.
ControlOptions withDefaults(ControlOptions options, const PlatformGeometry& geometry);

/// The control loop: one cycle is commands -> set-points -> exchange -> forward solution -> judgement ->
/// Snapshot. One thread owns it and calls cycle(); post() may be called from any thread.
class ControlLoop {
public:
    using Clock = std::chrono::steady_clock;
    using Sink = std::function<void(const Snapshot&)>;

    /// device and solver must outlive the loop. sink is called at the end of every cycle, on the owning
    /// thread.
    ControlLoop(PlatformDevice& device, const PlatformGeometry& geometry, const ForwardSolver& solver,
                const ControlOptions& options, Sink sink,
                std::function<Clock::time_point()> now = Clock::now);
    ~ControlLoop();

    void post(const OperatorCommand& command);
    void cycle();
    /// Stops motion and disables before the port is closed: sends Stop, then Disable, and returns when the
    /// drives are off, or says in a last Snapshot that they may not be. Never starts anything.
    void shutDown();

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace hexapose
