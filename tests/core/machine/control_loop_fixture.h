// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/units.h"
#include "core/geometry/geometry_file.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/machine/control_loop.h"
#include "core/record/event_codec.h"
#include "tests/support/scripted_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hexapose::testing {

/// m, as the loop's default for the laboratory platform.
inline constexpr double kSettleWindow = 2e-4;

inline Pose target() {
    return {{0.012, -0.004, 0.040}, {0.0, 0.0, radiansFromDeg(5.0)}};
}

/// The control loop of the laboratory platform on a scripted controller.
class ControlLoopTest : public ::testing::Test {
protected:
    ControlLoopTest() { rebuild({}); }
    void rebuild(const ControlOptions& options, std::unique_ptr<Planner> planner = nullptr) {
        if (!planner)
            planner = std::make_unique<ImmediatePlanner>(m_model);
        m_loop = std::make_unique<ControlLoop>(
            m_device, m_model, m_solver, options, [this](const Snapshot& s) { take(s); }, m_device.clock(),
            std::move(planner));
    }
    void take(const Snapshot& snapshot) {
        m_last = snapshot;
        m_states.push_back(snapshot.state);
        m_events.insert(m_events.end(), snapshot.events.begin(), snapshot.events.end());
    }
    void cycles(int count) {
        for (int k = 0; k < count; ++k)
            m_loop->cycle();
    }
    void until(RunState state, int atMost = 2000) {
        for (int k = 0; k < atMost && m_last.state != state; ++k)
            m_loop->cycle();
        ASSERT_EQ(m_last.state, state);
    }
    bool saw(EventCode code) const {
        return std::any_of(m_events.begin(), m_events.end(), [&](const Event& e) { return e.code == code; });
    }
    std::string detailOf(EventCode code) const {
        const auto found =
            std::find_if(m_events.begin(), m_events.end(), [&](const Event& e) { return e.code == code; });
        return found == m_events.end() ? "no such event" : payloadWords(*found);
    }
    int count(EventCode code) const {
        return static_cast<int>(
            std::count_if(m_events.begin(), m_events.end(), [&](const Event& e) { return e.code == code; }));
    }
    /// Enabled, in control, at rest.
    void enable() {
        m_device.state = ControllerState::Disabled;
        cycles(2);
        m_loop->post(EnableCommand{});
        until(RunState::Enabled);
        cycles(2);
    }
    void run() { m_loop->post(RunCommand{target()}); }
    /// To the middle of a move.
    void startMoving() {
        cycles(2);
        run();
        until(RunState::Moving);
        cycles(20);
    }
    bool motionWasSentSince(std::size_t mark) const {
        for (std::size_t k = mark + 1; k < m_device.received.size(); ++k) {
            const auto& a = m_device.received[k - 1].lengths;
            const auto& b = m_device.received[k].lengths;
            if (a && b && (*a - *b).norm() > 0.0)
                return true;
        }
        return false;
    }

    bool anySetPointSince(std::size_t mark) const {
        return std::any_of(m_device.received.begin() + static_cast<std::ptrdiff_t>(mark),
                           m_device.received.end(),
                           [](const SetPoints& sent) { return sent.lengths.has_value(); });
    }
    std::vector<DeviceRequest> requestsSince(std::size_t mark) const {
        std::vector<DeviceRequest> requests;
        for (std::size_t k = mark; k < m_device.received.size(); ++k)
            if (m_device.received[k].request != DeviceRequest::None)
                requests.push_back(m_device.received[k].request);
        return requests;
    }

    PlatformGeometry m_geometry = loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
    SharedModel m_model = makeModel(m_geometry);
    ScriptedDevice m_device{m_geometry};
    NewtonRaphson m_solver{m_geometry, NewtonOptions{}};
    Snapshot m_last;
    std::vector<RunState> m_states;
    std::vector<Event> m_events;
    std::unique_ptr<ControlLoop> m_loop;
};

} // namespace hexapose::testing
