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

/// The maxSpeed way in time from s = 0 to s = 1, from rest to rest, under limits of rate, acceleration and
/// jerk and a rate limit that depends on s. It takes at every instant the largest jerk after which the
/// hardest braking still keeps every limit: where the rate limit is constant, that is the seven-piece
/// profile.
class PathTiming {
public:
    struct State {
        double s = 0.0;            ///< 0 at the start, 1 at the end
        double rate = 0.0;         ///< 1/s
        double acceleration = 0.0; ///< 1/s^2
    };

    /// largestRate(s) limits the rate besides `bounds`; above zero for s in [0, 1].
    PathTiming(const PathBounds& bounds, const std::function<double(double)>& largestRate)
        : PathTiming(bounds, largestRate, nullptr) {}
    /// The same, or nothing when the time is up before it is done.
    static std::optional<PathTiming> plan(const PathBounds& bounds,
                                          const std::function<double(double)>& largestRate, PlanTimer& timer);

    double duration() const { return m_duration; } ///< s
    State at(double seconds) const; ///< at rest at the start before 0, at the end after the end

private:
    PathTiming(const PathBounds& bounds, const std::function<double(double)>& largestRate, PlanTimer* timer);

    struct Piece { ///< constant jerk
        double begin;
        State state;
        double jerk;
    };
    std::vector<Piece> m_pieces;
    double m_duration = 0.0;
};

} // namespace hexapose
