// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/experiment/closed_loop_trial.h"

#include "core/base/input_error.h"
#include "core/base/units.h"
#include "core/device/simulation/simulated_machine.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/motion/leg_path_check.h"
#include "core/motion/pose_motion_check.h"
#include "core/motion/straight_motion.h"
#include "core/record/event_codec.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace hexapose::experiment {

namespace {

constexpr double kRange = 0.13; ///< of the machine's size: offsets of the targets
constexpr double kAngleRange = radiansFromDeg(12.0);
constexpr int kTriesOfARange = 2000;
constexpr int kHalvings = 12;
constexpr double kPushAt = 0.4;        ///< of the planned time
constexpr double kSpeedWindow = 0.1;   ///< s, over which a speed is taken
constexpr double kTakesUpSpeed = 0.25; ///< s, that legs and loop have to take up a speed
constexpr int kBisections = 40;
constexpr double kSlow = 0.1;            ///< of the full speed: less is none
constexpr double kConstant = 5e-3;       ///< the commanded speed changes by no more where it is constant
constexpr int kMostCycles = 3000;        ///< of one move: half a minute
constexpr int kRestCycles = 100;         ///< a second after a move
constexpr double kTightTolerance = 1e-9; ///< m

double seconds(std::chrono::nanoseconds duration) {
    return std::chrono::duration<double>(duration).count();
}

/// One mode over all moves.
class Trial {
public:
    Trial(const TrialSettings& settings, const ForwardSolver& solver, MotionMode mode)
        : m_settings(settings), m_bounds(withDefaults(settings.control.bounds, settings.platform)),
          m_mode(mode), m_model(makeModel(settings.platform)), m_machine(settings.platform, settings.legs),
          m_exact(settings.platform, NewtonOptions{.tolerance = kTightTolerance}),
          m_loop(
              m_machine.device(), m_model, solver, settings.control,
              [this](const Snapshot& snapshot) { m_last = snapshot; }, m_machine.clock(),
              std::make_unique<ImmediatePlanner>(m_model)) {}

    MoveOutcome run(const Pose& target, int index) {
        const MoveOutcome outcome = move(target, index);
        // A push that outlasts the move is taken away: the next one begins at rest, with its own push alone.
        m_machine.push(index % kLegCount, 0.0);
        for (int cycle = 0; cycle < kRestCycles; ++cycle)
            m_loop.cycle();
        return outcome;
    }

private:
    MoveOutcome move(const Pose& target, int index) {
        m_outcome = {};
        m_outcome.to = target;
        for (int cycle = 0; cycle < kMostCycles && !m_last.measuredPose; ++cycle)
            m_loop.cycle();
        m_loop.post(RunCommand{target, m_mode});
        std::optional<double> begun;
        for (int cycle = 0; cycle < kMostCycles; ++cycle) {
            m_loop.cycle();
            const double now = seconds(m_last.time);
            for (const Event& event : m_last.events)
                if (event.code == EventCode::MoveStarted) {
                    begun = now;
                    begin(target, event.value());
                } else if (event.code == EventCode::Settled && begun) {
                    return finish(now - *begun);
                } else if (event.code != EventCode::Enabled && event.code != EventCode::Referencing &&
                           event.code != EventCode::Referenced && event.code != EventCode::Connected &&
                           event.code != EventCode::DataFresh && event.code != EventCode::NotSettled) {
                    throw std::runtime_error("move " + std::to_string(index + 1) + ", " +
                                             std::string(toWord(m_mode)) + " mode: " + formatEvent(event));
                }
            if (begun)
                observe(now - *begun, index);
        }
        finish(0.0);
        m_outcome.settleSeconds.reset();
        return m_outcome;
    }

    void begin(const Pose& target, double plannedSeconds) {
        m_true = truePose();
        m_outcome.from = m_true;
        m_outcome.plannedSeconds = plannedSeconds;
        m_displacement = displacement(m_true, target);
        m_plan.emplace(*m_model, *m_last.measuredPose, target, m_bounds);
        m_track.clear();
        m_constantSpeed = m_constantSince = 0.0;
    }

    Pose truePose() {
        m_true = m_exact.solve(m_machine.trueLengths(), m_true).pose;
        return m_true;
    }

    void observe(double time, int index) {
        const double pushBegin = kPushAt * m_outcome.plannedSeconds;
        const bool pushed = time >= pushBegin && time < pushBegin + m_settings.pushSeconds;
        m_machine.push(index % kLegCount, pushed ? m_settings.push : 0.0);

        const Pose pose = truePose();
        m_track.push_back({time, pose.offset});
        const Twist gone = displacement(m_outcome.from, pose);
        const double length = m_displacement.head<3>().norm();
        const double turn = m_displacement.tail<3>().norm();
        // The place along the path: by position, or by angle where it only turns.
        const double part = length > 0.0 ? gone.head<3>().dot(m_displacement.head<3>()) / (length * length)
                            : turn > 0.0 ? gone.tail<3>().dot(m_displacement.tail<3>()) / (turn * turn)
                                         : 0.0;
        const double place = std::clamp(part, 0.0, 1.0);
        const Pose alongPath = displaced(m_outcome.from, place * m_displacement);
        const Twist beside = displacement(pose, alongPath);
        Moment moment{time, beside.head<3>().norm(), beside.tail<3>().norm(), 0.0, commandedSpeed(time)};
        const auto before = std::find_if(m_track.rbegin(), m_track.rend(), [&](const auto& p) {
            return p.first <= time - kSpeedWindow + 1e-9;
        });
        if (before != m_track.rend()) {
            moment.speed = (pose.offset - before->second).norm() / (time - before->first);
            if (m_settings.push == 0.0 && time - m_constantSince >= kSpeedWindow + kTakesUpSpeed &&
                m_mode == MotionMode::Workspace)
                m_outcome.speedError = std::max(m_outcome.speedError.value_or(0.0),
                                                std::abs(moment.speed / moment.plannedSpeed - 1.0));
        }
        m_outcome.largestDeviation = std::max(m_outcome.largestDeviation, moment.deviation);
        m_outcome.largestAngleDeviation = std::max(m_outcome.largestAngleDeviation, moment.angleDeviation);
        m_outcome.moments.push_back(moment);
    }

    /// The planned speed at the place where the reference is: in joint mode, at the same time.
    double commandedSpeed(double time) {
        double at = time;
        if (m_mode == MotionMode::Workspace && m_last.targetPose) {
            const double gone = (m_last.targetPose->offset - m_plan->from().offset).norm();
            double low = 0.0, high = m_plan->duration();
            for (int k = 0; k < kBisections; ++k) {
                at = 0.5 * (low + high);
                ((m_plan->at(at).pose.offset - m_plan->from().offset).norm() < gone ? low : high) = at;
            }
        }
        const double speed = m_plan->at(at).twist.head<3>().norm();
        if (speed < kSlow * m_bounds.speed ||
            std::abs(speed - m_constantSpeed) > kConstant * m_constantSpeed) {
            m_constantSpeed = speed;
            m_constantSince = time;
        }
        return speed;
    }

    MoveOutcome finish(double time) {
        const Twist error = displacement(truePose(), m_outcome.to);
        m_outcome.settleSeconds = time - m_outcome.plannedSeconds;
        m_outcome.finalError = error.head<3>().norm();
        m_outcome.finalAngle = error.tail<3>().norm();
        return m_outcome;
    }

    const TrialSettings& m_settings;
    MotionBounds m_bounds;
    MotionMode m_mode;
    SharedModel m_model;
    SimulatedMachine m_machine;
    NewtonRaphson m_exact;
    Snapshot m_last;
    ControlLoop m_loop;
    MoveOutcome m_outcome;
    Twist m_displacement = Twist::Zero();
    Pose m_true;
    std::optional<StraightMotion> m_plan;
    double m_constantSpeed = 0.0; ///< m/s, commanded
    double m_constantSince = 0.0; ///< s
    std::vector<std::pair<double, Eigen::Vector3d>> m_track;
};

} // namespace

std::vector<Pose> drawTargets(const TrialSettings& settings) {
    const PlatformGeometry& platform = settings.platform;
    MotionLimits limits = motionLimits(platform, std::nullopt, std::nullopt);
    const MotionBounds bounds = withDefaults(settings.control.bounds, platform);
    const PlatformModel model(platform);
    // Ways from one pose to the next, smaller ones where a machine has no room for large ones.
    for (int halving = 0; halving < kHalvings; ++halving) {
        const double part = std::pow(0.5, halving);
        std::mt19937_64 random(settings.seed);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        std::vector<Pose> targets;
        Pose from;
        for (int tries = 0; tries < kTriesOfARange && static_cast<int>(targets.size()) < settings.moves;
             ++tries) {
            PoseVector x;
            for (int k = 0; k < 6; ++k)
                x[k] = part * unit(random) * (k < 3 ? kRange * platform.size() : kAngleRange);
            const Pose to = Pose::fromVector(x);
            if (!checkPose(model, limits, to).ok() || !checkLegPath(model, limits, from, to).ok() ||
                !checkMotion(model, limits, StraightMotion(model, from, to, bounds)).ok())
                continue;
            targets.push_back(to);
            from = to;
        }
        if (static_cast<int>(targets.size()) == settings.moves)
            return targets;
    }
    throw InputError("\"" + platform.name + "\"", "has no room for the moves of the experiment");
}

std::vector<MoveOutcome> runTrial(const TrialSettings& settings, const ForwardSolver& solver,
                                  const std::vector<Pose>& targets, MotionMode mode,
                                  const std::function<void(double)>& progress) {
    Trial trial(settings, solver, mode);
    std::vector<MoveOutcome> outcomes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        progress(static_cast<double>(i) / static_cast<double>(targets.size()));
        outcomes.push_back(trial.run(targets[i], static_cast<int>(i)));
    }
    progress(1.0);
    return outcomes;
}

} // namespace hexapose::experiment
