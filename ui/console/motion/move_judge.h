// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kinematics/platform_model.h"
#include "core/machine/control_loop.h"
#include "core/motion/limits.h"
#include "core/record/snapshot.h"

namespace hexapose {

/// Judges poses and moves as the loop will, before they are asked for.
class MoveJudge {
public:
    explicit MoveJudge(const PlatformGeometry& geometry);
    /// What the loop works with; until then what follows from the machine alone.
    void setControl(const ControlOptions& options);
    /// The controller's own limits narrow those of the platform.
    void follow(const Snapshot& snapshot);

    const PlatformGeometry& geometry() const { return m_model->geometry(); }
    const MotionLimits& limits() const { return m_limits; }
    /// Of a motion that begins at this pose.
    MotionLimits limitsAt(const Pose& pose) const;
    MotionCheck pose(const Pose& pose) const;
    /// The whole way in a mode.
    MotionCheck move(const Pose& from, const Pose& to, MotionMode mode) const;

private:
    void applyControl();

    SharedModel m_model;
    ControlOptions m_control; ///< complete
    MotionLimits m_limits;
};

} // namespace hexapose
