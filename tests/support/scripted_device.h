// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"
#include "core/geometry/platform_geometry.h"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hexapose::testing {

/// A controller in one piece with the time it lives in: every read takes one period of a clock that only
/// it moves. Legs follow first order; states and refusals as the line protocol has them.
class ScriptedDevice : public PlatformDevice {
public:
    using Clock = std::chrono::steady_clock;
    explicit ScriptedDevice(const PlatformGeometry& geometry);

    const DeviceFeedback& read() override;
    void write(const SetPoints& setPoints) override;
    void interrupt() override { ++interruptions; }
    Clock::time_point now() const { return m_now; }
    std::function<Clock::time_point()> clock() {
        return [this] { return m_now; };
    }

    // The script: what the test changes between cycles.
    ControllerState state = ControllerState::Unreferenced;
    LinkState link = LinkState::Connected;
    bool silent = false;                     ///< no measurement comes
    bool ignoresReference = false;           ///< stays unreferenced
    bool ignoresEnable = false;              ///< stays disabled
    bool ignoresDisable = false;             ///< stays enabled
    bool ignoresClear = false;               ///< neither answers it nor does it
    bool stuck = false;                      ///< legs do not move
    std::optional<int> stuckLeg;             ///< 0..5: this one does not
    bool deaf = false;                       ///< takes no set-point and echoes none
    bool ignoresStop = false;                ///< stays enabled
    bool stopsOnlyWhenEnabled = false;       ///< as the protocol's diagram of states has it
    std::chrono::milliseconds late{0};       ///< added to the next read: the host stood still
    bool echoes = true;                      ///< tells which set-point it accepted last
    std::optional<LegLengths> reportInstead; ///< a bad measurement
    std::function<void()> during;            ///< called while a read waits
    std::vector<DeviceNotice> notices;       ///< handed out with the next read
    double leftToSettle = 0.3;               ///< part of the distance that is left after a period
    std::optional<double> minLength, maxLength;
    std::string name;

    // What the test looks at.
    LegLengths lengths;
    std::vector<SetPoints> received;
    int interruptions = 0;

private:
    void obey(DeviceRequest request);

    DeviceFeedback m_feedback;
    LegLengths m_home;
    std::int32_t m_setNumber = 0;
    std::optional<std::int32_t> m_accepted;
    Clock::time_point m_now{};
    Clock::time_point m_measuredAt{};
};

} // namespace hexapose::testing
