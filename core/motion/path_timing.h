// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/plan_budget.h"

#include <functional>
#include <optional>
#include <vector>

namespace hexapose {

/// Limits of the path parameter s: its rate, acceleration and jerk (1/s, 1/s^2, 1/s^3), all above zero.
struct PathBounds {
    double rate = 0.0;
    double acceleration = 0.0;
    double jerk = 0.0;
};

/// The fastest timing from s = 0 to s = 1, from rest to rest, under limits of rate, acceleration and
/// jerk and a rate limit that depends on s. Where that limit is nowhere below the other one it is the
/// seven-piece profile. Elsewhere it takes at every instant the largest jerk after which the hardest braking
/// still keeps every limit, in some thousand steps at most: on a path that takes hundreds of times as long as
/// the acceleration does, the acceleration is slowed down to 1/500 of the path's time.
class PathTiming {
public:
    struct State {
        double s = 0.0;            ///< 0 at the start, 1 at the end
        double rate = 0.0;         ///< 1/s
        double acceleration = 0.0; ///< 1/s^2
    };

    /// largestRate(s) limits the rate besides `bounds`; above zero for s in [0, 1]. Of bounds that are no
    /// positive numbers: a path of infinite duration, at rest at its start.
    PathTiming(const PathBounds& bounds, const std::function<double(double)>& largestRate)
        : PathTiming(bounds, largestRate, nullptr) {}
    /// The same, or nothing when the time is up before it is done.
    static std::optional<PathTiming> plan(const PathBounds& bounds,
                                          const std::function<double(double)>& largestRate, PlanTimer& timer);

    double duration() const { return m_duration; } ///< s
    State at(double seconds) const;              ///< at rest at the start before 0, at the end after the end
    double maxRate() const { return m_maxRate; } ///< reached at any time, 1/s
    double maxAcceleration() const { return m_maxAcceleration; } ///< its magnitude, 1/s^2

private:
    PathTiming(const PathBounds& bounds, const std::function<double(double)>& largestRate, PlanTimer* timer);

    struct Piece { ///< constant jerk
        double begin;
        State state;
        double jerk;
    };
    void add(double jerk, double seconds);
    void addProfile(const PathBounds& bounds);
    void finish();

    std::vector<Piece> m_pieces;
    State m_end; ///< of the pieces so far
    double m_duration = 0.0;
    double m_maxRate = 0.0;
    double m_maxAcceleration = 0.0;
};

} // namespace hexapose
