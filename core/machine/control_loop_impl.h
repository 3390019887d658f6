// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/singularity.h"
#include "core/machine/control_loop.h"
#include "core/machine/feedback_monitor.h"
#include "core/machine/following_error_monitor.h"
#include "core/machine/machine_state.h"
#include "core/machine/move.h"
#include "core/tracking/jog_motion.h"
#include "core/tracking/workspace_controller.h"

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hexapose {

/// What the loop's thread owns. Split over control_loop.cpp (the cycle), control_loop_commands.cpp (the
/// operator's side), control_loop_feedback.cpp (the controller's side) and control_loop_motion.cpp (motions).
struct ControlLoop::Impl {
    using Now = std::function<Clock::time_point()>;

    Impl(PlatformDevice& theDevice, const PlatformGeometry& theGeometry, const ForwardSolver& theSolver,
         const ControlOptions& theOptions, Sink theSink, Now theNow);

    // What a cycle is made of, in order.
    void takeCommands(Clock::time_point time);
    SetPoints nextSetPoints(Clock::time_point time);
    void takeFeedback(Clock::time_point time);
    void watchIdentity();
    void watch(Clock::time_point time);
    void advanceMove(Clock::time_point time);
    void publish(Clock::time_point time);

    void on(const RunCommand& command, Clock::time_point time);
    void on(const SweepCommand& command, Clock::time_point time);
    void on(const JogCommand& command, Clock::time_point time);
    void on(const JogReleaseCommand& command, Clock::time_point time);
    void on(const SpeedCommand& command, Clock::time_point time);
    void on(const StopCommand& command, Clock::time_point time);
    void on(const ReferenceCommand& command, Clock::time_point time);
    void on(const EnableCommand& command, Clock::time_point time);
    void on(const DisableCommand& command, Clock::time_point time);
    void on(const ClearCommand& command, Clock::time_point time);
    void takeNotice(const DeviceNotice& notice, Clock::time_point time);
    void takeNoAnswer(const DeviceNotice& notice);
    void takeRefusal(const DeviceNotice& notice, Clock::time_point time);
    void followController();
    void noteStateChange(ControllerState before, RunState was);
    void solve();
    LegLengths holdPoint() const;

    // Motions.
    using MotionWish = std::variant<RunCommand, SweepCommand>;
    /// The motion that a wish means from here and now, judged whole.
    struct Planned {
        MotionCheck check;
        std::unique_ptr<MotionGenerator> law; ///< only where asked for
    };
    Planned plan(const MotionWish& wish, bool withLaw);
    void prepareMotion(const MotionWish& wish, MachineEvent event, Clock::time_point time);
    void beginMotion(Clock::time_point time);
    std::optional<std::string> unfitToMove() const;
    std::optional<Event> nearLimit() const;

    /// What the table says about an event; the state follows. A command that it refuses is told.
    Transition apply(MachineEvent event);
    bool accepts(MachineEvent event) const { return transition(machine, event).defined; }
    /// Ends whatever moves and sends Stop; it stays stopped until Clear.
    void stop(Event cause);
    void halt(); ///< the same without a word
    void nameStop(Clock::time_point time);
    void dropMotion();
    RunState state() const {
        return feedback.link == LinkState::ListenOnly ? RunState::Disabled : machine.run;
    }
    bool moving() const { return move && move->moving(); }
    bool takesCommands() const { return feedback.link == LinkState::Connected; }
    void refuse(MachineEvent what) {
        raise({EventCode::CommandRefused, 0.0,
               std::string(toWord(what)) + " in " + std::string(toWord(state()))});
    }
    static constexpr int kTriesAgain = 2; ///< of a request that goes unanswered
    void askToReference() {
        referenceTries = kTriesAgain;
        referenceTaken = false;
    }
    void raise(Event event) { events.push_back(std::move(event)); }
    MotionLimits limits() const;
    Move::Timing timing() const;
    void request(DeviceRequest what) {
        if (pendingRequest != DeviceRequest::Stop)
            pendingRequest = what;
    }

    PlatformDevice& device;
    const PlatformGeometry geometry;
    const ForwardSolver& solver;
    const ControlOptions options;
    Sink sink;
    Now now;
    const Clock::time_point sessionStart;

    std::mutex commandMutex;
    std::vector<OperatorCommand> commands;
    std::atomic<bool> stopWaits{false}; ///< among them: the present cycle is to end

    /// What the controller says of itself.
    struct Identity {
        std::string name;
        std::optional<double> minLength, maxLength;
        bool operator==(const Identity&) const = default;
    };
    std::optional<Identity> identity;
    FeedbackMonitor monitor;
    FollowingErrorMonitor follow;
    DeviceFeedback feedback;
    std::optional<LegLengths> measured;
    ForwardResult solution;
    std::chrono::nanoseconds solveTime{0};
    std::optional<Pose> measuredPose;
    Pose lastPose; ///< start of the next solution: the last usable one, home before the first
    double homeDeterminant;
    SingularityMeasure singularity; ///< at the measured pose

    MachineState machine;
    std::optional<Move> move;
    std::optional<MotionWish> wish;       ///< of the move that is being prepared
    std::unique_ptr<MotionGenerator> law; ///< of the present motion, and of the pose that is held after it
    JogMotion* jog = nullptr;             ///< the law, when it is a jog
    Clock::time_point jogHeldAt{};        ///< the button was last said to be held
    WorkspaceController workspace;
    double speed = 1.0;                  ///< 0..1, the operator's
    MotionMode mode = MotionMode::Joint; ///< of the present or last motion
    Clock::time_point lastStep{};
    std::optional<LegLengths> commanded;
    std::optional<Pose> commandedPose;
    std::optional<Pose> goal;
    bool tookOver = false;     ///< the operator asked for something on this link: set-points may go out
    bool stopWhenBack = false; ///< the link was lost in mid-move
    ControllerState knownState = ControllerState::Unknown; ///< of this link
    int referenceTries = 0;                                ///< left, should HOME go unanswered
    int enableTries = 0;
    bool referenceTaken = false; ///< HOME was answered: it takes its time now
    DeviceRequest pendingRequest = DeviceRequest::None;
    bool wasStale = true;
    std::string unnamedStop; ///< a refusal that stopped the move and waits for the state that explains it
    Clock::time_point unnamedSince{};
    Clock::time_point lastSetRefusal{};
    std::string lastSetRefusalText;
    std::uint64_t cycleCount = 0;
    std::vector<Event> events;
};

} // namespace hexapose
