// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device/platform_device.h"
#include "core/machine/control_loop.h"
#include "core/record/log_writer.h"
#include "core/report/settled_sample.h"
#include "core/session/pose_sequence.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hexapose {

/// The operator's main job without a screen: connect, reference, enable, visit the attitudes, record. Runs on
/// the calling thread.
class PoseRun {
public:
    struct Options {
        MotionMode mode = MotionMode::Joint;
        double speed = 1.0;                 ///< 0..1, part of full speed
        PoseEnvelope envelope;              ///< no further from home
        std::optional<SweepSettings> sweep; ///< in the place of the first target
        bool clearFirst = false;            ///< clear a stop or fault that the controller is in
        std::chrono::seconds connectWithin{10};
    };

    PoseRun(PlatformDevice& device, const PlatformGeometry& geometry, const ForwardSolver& solver,
            LogWriter& log, std::vector<Pose> targets, const Options& options);

    /// Until all attitudes are visited, something ends the run, or `interrupted` says so; then stops and
    /// disables.
    void run(const std::function<bool()>& interrupted);

    const std::vector<SettledSample>& samples() const { return m_samples; }
    std::size_t visited() const { return m_sequence.finished(); }
    /// Why not all attitudes were visited, in words; nothing when they were.
    const std::optional<std::string>& failure() const { return m_failure; }

private:
    void take(const Snapshot& snapshot);
    void checkConnection(const Snapshot& snapshot);
    std::string endingWords(const Snapshot& snapshot) const;

    LogWriter& m_log;
    Options m_options;
    PoseSequence m_sequence;
    SettledSampler m_sampler;
    ControlLoop m_loop;
    std::vector<SettledSample> m_samples;
    std::optional<std::string> m_failure;
    std::string m_uselessAnswer; ///< what came in place of a connection
    bool m_connected = false;
    bool m_clearPosted = false;
    bool m_over = false;
    bool m_ended = false; ///< nothing but the closing is left
};

} // namespace hexapose
