// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/units.h"
#include "core/device/simulation/simulated_machine.h"
#include "core/geometry/geometry_file.h"
#include "core/geometry/twist.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/machine/control_loop.h"
#include "core/record/event_codec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace hexapose::testing {

/// The control loop on the simulated machine, through all bytes, with legs that lag by 50 to 150 ms.
class SimulatedLoop : public ::testing::Test {
protected:
    void build(const VirtualPlatformOptions& legs = {}, const ControlOptions& options = {},
               std::chrono::milliseconds period = std::chrono::milliseconds(10)) {
        m_loop.reset();
        m_last = {};
        m_events.clear();
        m_machine = std::make_unique<SimulatedMachine>(m_geometry, legs, period);
        m_loop = std::make_unique<ControlLoop>(
            m_machine->device(), m_model, m_solver, options, [this](const Snapshot& s) { take(s); },
            m_machine->clock(), std::make_unique<ImmediatePlanner>(m_model));
    }
    void take(const Snapshot& snapshot) {
        m_last = snapshot;
        m_events.insert(m_events.end(), snapshot.events.begin(), snapshot.events.end());
    }
    void cycles(int count) {
        for (int k = 0; k < count; ++k)
            m_loop->cycle();
    }
    void until(RunState state, int atMost = 4000) {
        for (int k = 0; k < atMost && m_last.state != state; ++k)
            m_loop->cycle();
        ASSERT_EQ(m_last.state, state)
            << "last event: " << (m_events.empty() ? "" : formatEvent(m_events.back()));
    }
    /// Referenced and enabled, at home, taken over.
    void enable() {
        build();
        until(RunState::Unreferenced);
        m_loop->post(ReferenceCommand{});
        until(RunState::Disabled);
        m_loop->post(EnableCommand{});
        until(RunState::Enabled);
        m_events.clear();
    }
    Pose truePose() const {
        return m_exact.solve(m_machine->trueLengths(), m_last.measuredPose.value_or(Pose{})).pose;
    }
    bool saw(EventCode code) const {
        return std::any_of(m_events.begin(), m_events.end(), [&](const Event& e) { return e.code == code; });
    }
    std::string detailOf(EventCode code) const {
        const auto found =
            std::find_if(m_events.begin(), m_events.end(), [&](const Event& e) { return e.code == code; });
        return found == m_events.end() ? "no such event" : payloadWords(*found);
    }

    PlatformGeometry m_geometry = loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
    SharedModel m_model = makeModel(m_geometry);
    NewtonRaphson m_solver{m_geometry, NewtonOptions{}};
    NewtonRaphson m_exact{m_geometry, NewtonOptions{}};
    Snapshot m_last;
    std::vector<Event> m_events;
    std::unique_ptr<SimulatedMachine> m_machine;
    std::unique_ptr<ControlLoop> m_loop;
};

} // namespace hexapose::testing
