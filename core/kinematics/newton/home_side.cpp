// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/newton/home_side.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>

namespace hexapose {

namespace {

constexpr int kPointsOnWay = 10;
/// Where the determinant comes closer to zero than this part of home's, more points are looked at.
constexpr double kNearSide = 0.05;
constexpr int kFinePoints = 64;
/// Path following: first and shortest part of the path, and what a part may ask of Newton.
constexpr double kFirstPart = 1.0 / 16.0;
constexpr double kShortestPart = 1.0 / 4096.0;
constexpr int kMostCorrections = 5;
constexpr double kLongestCorrection = 0.12; // machine sizes
/// Along the path; only its end is solved to the tolerance asked for.
constexpr double kPathTolerance = 1e-6;

Eigen::Quaterniond turnOf(const Placement& place) {
    return Eigen::Quaterniond(place.w, place.v[0], place.v[1], place.v[2]).normalized();
}

} // namespace

double HomeSide::determinantRatio(const Placement& place) const noexcept {
    return m_equations.jacobian(m_equations.evaluate(place, LegEquations::Legs::Zero())).determinant() /
           m_homeDeterminant;
}

bool HomeSide::isConnected(const Placement& from, const Placement& to) const noexcept {
    const Eigen::Quaterniond first = turnOf(from), last = turnOf(to);
    const auto least = [&](int points) {
        double smallest = determinantRatio(to);
        for (int i = 0; i < points && smallest > 0.0; ++i) {
            const double part = static_cast<double>(i) / points;
            const Eigen::Quaterniond q = first.slerp(part, last);
            smallest = std::min(
                smallest,
                determinantRatio({from.centroid + part * (to.centroid - from.centroid), q.w(), q.vec()}));
        }
        return smallest;
    };
    const double coarse = least(kPointsOnWay);
    return coarse > kNearSide || (coarse > 0.0 && least(kFinePoints) > 0.0);
}

std::optional<Placement> HomeSide::correct(Placement place, const LegEquations::Legs& target,
                                           double tolerance, int& iterations) const noexcept {
    double moved = 0.0;
    for (int i = 0; i <= kMostCorrections; ++i) {
        const auto at = m_equations.evaluate(place, target);
        LegEquations::Step step;
        if (!(m_equations.newtonStep(at, step) * m_homeDeterminant > 0.0))
            return std::nullopt;
        if (at.residual <= tolerance)
            return place;
        moved += step.norm();
        if (!(moved <= kLongestCorrection))
            return std::nullopt;
        place = m_equations.moved(place, step);
        ++iterations;
    }
    return std::nullopt;
}

std::optional<Placement> HomeSide::follow(const Placement& from, const LegEquations::Legs& target,
                                          double tolerance, int& iterations) const noexcept {
    const LegEquations::Legs first = m_equations.evaluate(from, LegEquations::Legs::Zero()).length;
    Placement place = from;
    double done = 0.0, part = kFirstPart;
    while (done < 1.0) {
        const double next = std::min(1.0, done + part);
        const auto corrected =
            correct(place, first + next * (target - first),
                    next < 1.0 ? std::max(kPathTolerance, tolerance) : tolerance, iterations);
        if (corrected) {
            place = *corrected;
            done = next;
            part *= 2.0;
        } else if ((part *= 0.5) < kShortestPart) {
            return std::nullopt;
        }
    }
    return place;
}

} // namespace hexapose
