// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/forward_solver.h"
#include "core/kinematics/platform_model.h"
#include "core/machine/command.h"
#include "core/machine/control_options.h"
#include "core/machine/cycle_observer.h"
#include "core/machine/planner.h"
#include "core/record/snapshot.h"

#include <chrono>
#include <functional>
#include <memory>

namespace hexapose {

class PlatformDevice;

/// The control loop. One cycle is: read -> estimate -> supervise (the controller's notices, the operator's
/// commands, the watch) -> generate -> write -> publish a Snapshot. So a stop leaves in the cycle in which
/// its cause was measured. One thread owns the loop and calls cycle(); post() may be called from any thread.
class ControlLoop {
public:
    using Clock = std::chrono::steady_clock;
    using Sink = std::function<void(const Snapshot&)>;

    /// device and solver outlive the loop. sink is called at the end of every cycle, on the owning thread.
    /// planner: a PlanningThread if not given; a loop in simulated time wants an ImmediatePlanner.
    ControlLoop(PlatformDevice& device, SharedModel model, const ForwardSolver& solver,
                const ControlOptions& options, Sink sink, std::function<Clock::time_point()> now = Clock::now,
                std::unique_ptr<Planner> planner = nullptr);
    ~ControlLoop();

    /// A Stop ends the wait of the present cycle.
    void post(const OperatorCommand& command);
    void cycle();
    /// Before the port is closed: whatever moves is stopped, and where anything was enabled Stop and Disable
    /// are sent, whatever state the controller reports. Returns when the drives are off, or says in a
    /// last Snapshot that they may not be. Never starts anything, and never clears: that is a person's
    /// decision.
    void shutDown();
    /// Null: nobody. Outlives the loop.
    void setObserver(CycleObserver* observer);

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace hexapose
