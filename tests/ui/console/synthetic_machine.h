// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device/interruption.h"
#include "core/device/platform_device.h"
#include "core/geometry/platform_geometry.h"
#include "core/kinematics/forward_solver.h"
#include "core/record/snapshot.h"

#include <memory>

namespace hexapose::testing {

/// In milliseconds, only against hanging.
inline constexpr int kPatienceMs = 20000;

PlatformGeometry laboratoryPlatform();
std::shared_ptr<const ForwardSolver> newtonSolver(const PlatformGeometry& geometry);
Pose poseOf(double xMm, double yMm, double zMm, double alphaDeg, double betaDeg, double gammaDeg);

/// As the loop would give it: fresh lengths of a pose, in a state, at a time in seconds.
Snapshot snapshotAt(const PlatformGeometry& geometry, const Pose& measured, const Pose& target,
                    RunState state, double time);

/// A controller that is where it was sent at once, and counts what it is asked.
class InstantDevice final : public PlatformDevice {
public:
    explicit InstantDevice(const PlatformGeometry& geometry) : m_lengths(geometry.homeLengths()) {}
    const DeviceFeedback& read() override;
    void write(const SetPoints& setPoints) override;
    void interrupt() override { m_interruption.request(); }

private:
    DeviceFeedback m_feedback;
    Interruption m_interruption;
    LegLengths m_lengths;
    ControllerState m_state = ControllerState::Unreferenced;
    bool m_named = false;
    std::int64_t m_cycle = 0;
};

} // namespace hexapose::testing
