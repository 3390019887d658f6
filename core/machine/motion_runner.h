// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/machine/command.h"
#include "core/machine/control_options.h"
#include "core/machine/move.h"
#include "core/machine/planner.h"
#include "core/record/event.h"
#include "core/tracking/jog_motion.h"
#include "core/tracking/workspace_controller.h"

#include <memory>
#include <optional>

namespace hexapose {

/// The motion that was asked for: its plan, its preparation, its set-points, its end; and the set-point that
/// is held at rest. Knows no device and no table: the supervisor decides when.
class MotionRunner {
public:
    using Clock = std::chrono::steady_clock;

    /// What is known in a cycle.
    struct Cycle {
        Clock::time_point time;
        ControllerState controller = ControllerState::Unknown;
        bool stale = true;
        std::optional<LegLengths> fresh;    ///< measured in this cycle, m
        std::optional<LegLengths> measured; ///< last, m
        std::optional<Pose> pose;           ///< of the last measurement
        MotionLimits limits;
        bool held = false; ///< the motion is held on its path
    };

    /// options: complete. planner outlives the runner.
    MotionRunner(SharedModel model, const ControlOptions& options, Planner& planner);

    // ---- the plan. Needs a measured pose.
    struct Order {
        MotionRequest request;
        MotionId id = kNoMotion;
        SharedPlan plan; ///< given, or made
    };
    void order(Order order, const Cycle& cycle);
    /// What the planning found; nothing while it goes on.
    std::optional<MotionCheck> plannedCheck();
    MotionId orderId() const { return m_order ? m_order->id : kNoMotion; }
    void forgetOrder() { m_order.reset(); }

    // ---- the motion
    /// The order becomes the motion: reference and enable, as far as the controller's state asks for it.
    void prepare(const Cycle& cycle);
    /// In phase Ready: whether it may begin from here. The plan is made anew, a few times, where the platform
    /// has left its start, as a referencing does; nothing meanwhile.
    std::optional<MotionCheck> startCheck(const Cycle& cycle);
    void begin(const Cycle& cycle);
    void beginJog(const JogCommand& command, const Cycle& cycle);
    /// Another repeat of the press that began the present jog.
    void holdJog(const JogCommand& command, Clock::time_point time);
    void releaseJog();
    bool isJog(MotionId id) const { return m_jog != nullptr && m_jogId == id; }
    /// A press whose jog has ended, or comes to rest because it was released or not repeated in time. Presses
    /// without an id cannot be told apart.
    bool isEndedJog(MotionId id) const { return id != kNoMotion && id == m_endedJog; }
    /// After each measurement: what happened to the motion.
    std::optional<Event> update(const Cycle& cycle);
    /// It settled. In workspace mode the pose is held from here on, in joint mode the set-point.
    void settle();
    /// Forgets motion, order and set-point.
    void end();

    bool active() const { return m_move.has_value(); } ///< from the preparation to the settled platform
    std::optional<Move::Phase> phase() const {
        return m_move ? std::optional(m_move->phase()) : std::nullopt;
    }
    bool preparing() const { return m_move && m_move->preparing(); }
    DeviceRequest nextRequest() { return m_move ? m_move->nextRequest() : DeviceRequest::None; }
    /// Events of the generator, such as a jog that a limit ended.
    std::optional<Event> takeEvent() { return m_generator ? m_generator->takeEvent() : std::nullopt; }

    // ---- set-points
    /// Time goes on, in every cycle.
    void tick(Clock::time_point time);
    /// The set-point of this cycle, m; nothing where there is nothing to hold.
    std::optional<LegLengths> nextSetPoint(const Cycle& cycle);
    const std::optional<LegLengths>& setPoint() const { return m_setPoint; } ///< in force, m
    bool generates() const {
        return m_generator != nullptr;
    } ///< a motion, or a pose that is held by measuring
    std::optional<PoseReference> reference() const {
        return m_generator ? m_generator->reference() : std::nullopt;
    }
    bool stalls() const { return m_generator && m_generator->stalls(); }

    void setSpeed(double speedOverride) { m_speed = speedOverride; }
    double speed() const { return m_speed; }
    MotionMode mode() const { return m_mode; } ///< of the present or last motion
    MotionId id() const { return m_id; }       ///< of the present or last motion
    double duration() const { return m_generator ? m_generator->duration() : 0.0; } ///< s, planned
    const std::optional<Pose>& goal() const { return m_goal; }

private:
    PlanStart startOf(const Cycle& cycle) const;
    LegLengths holdPoint(const Cycle& cycle) const;
    void submit(const Cycle& cycle);
    void noteJogEnded();

    SharedModel m_model;
    const ControlOptions m_options;
    Planner& m_planner;

    std::optional<Order> m_order;
    int m_replansLeft = 0;
    std::optional<Move> m_move;
    std::unique_ptr<MotionGenerator> m_generator; ///< of the present motion, and of the pose held after it
    JogMotion* m_jog = nullptr;                   ///< the generator, when it is a jog
    Clock::time_point m_jogHeldAt{};
    MotionId m_jogId = kNoMotion; ///< of the press that began the present or last jog
    MotionId m_endedJog = kNoMotion;
    WorkspaceController m_workspace;
    std::optional<LegLengths> m_setPoint;
    std::optional<Pose> m_goal;
    double m_speed = 1.0; ///< 0..1, the operator's
    MotionMode m_mode = MotionMode::Joint;
    MotionId m_id = kNoMotion;
    Clock::time_point m_lastTick{};
    std::chrono::nanoseconds m_step{0}; ///< of the path's time, for this cycle
};

} // namespace hexapose
