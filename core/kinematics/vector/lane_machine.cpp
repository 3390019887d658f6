// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/vector/lane_machine.h"

#include "core/base/units.h"
#include "core/kinematics/pose_samples.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace hexapose {

namespace {

/// The largest box that is tried about home, in machine sizes and radians; then the next smaller ones.
constexpr double kOffsetBox = 0.2;
constexpr double kAngleBox = radiansFromDeg(60.0);
constexpr double kNextBox = 0.85;
constexpr int kMostBoxes = 20;
/// Rays from home to the corners of the box and to so many other points of its surface, and looks at each.
constexpr int kRays = 300;
constexpr int kLooks = 20;
/// A ray on which the determinant has fallen below the first part of home's must not see it rise above the
/// second again: then who finds more than the second in the box knows that the straight path from home is
/// free.
constexpr double kLostShare = 0.03;
constexpr double kCertainShare = 0.1;
constexpr std::uint64_t kSeed = 20230382;

/// The triple of legs, then the other, in which the first spans the largest volume at home.
std::array<int, kLegCount> eliminationOrder(const std::array<Eigen::Vector3d, kLegCount>& legs) {
    std::array<int, kLegCount> best{};
    double largest = -1.0;
    for (int i = 0; i < kLegCount; ++i)
        for (int j = i + 1; j < kLegCount; ++j)
            for (int k = j + 1; k < kLegCount; ++k) {
                const auto leg = [&legs](int n) { return legs[static_cast<std::size_t>(n)].normalized(); };
                const double volume = std::abs(leg(i).cross(leg(j)).dot(leg(k)));
                if (volume <= largest)
                    continue;
                largest = volume;
                best = {i, j, k};
                auto rest = best.begin() + 3;
                for (int n = 0; n < kLegCount; ++n)
                    if (n != i && n != j && n != k)
                        *rest++ = n;
            }
    return best;
}

void repeatLast(LaneMachine::Triples& row) {
    for (const std::size_t last : {placeInMemory(2), placeInMemory(5)})
        row[last + 1] = row[last];
}

/// +1 for an even permutation, -1 for an odd one.
double parity(const std::array<int, kLegCount>& order) {
    double sign = 1.0;
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j)
            if (order[i] > order[j])
                sign = -sign;
    return sign;
}

} // namespace

LaneMachine makeLaneMachine(const LegEquations& equations, double homeDeterminant) {
    using Legs = LegEquations::Legs;
    using Matrix = LegEquations::Matrix;
    LaneMachine machine;
    machine.size = equations.size();
    machine.spread = equations.spread();
    const Placement home{equations.home() + equations.centroidInP(), 1.0, Eigen::Vector3d::Zero()};
    const LegEquations::Evaluation at = equations.evaluate(home, Legs::Zero());
    std::array<Eigen::Vector3d, kLegCount> legs;
    for (int i = 0; i < kLegCount; ++i)
        legs[static_cast<std::size_t>(i)] = {at.dx[i], at.dy[i], at.dz[i]};
    machine.order = eliminationOrder(legs);

    Matrix J = equations.jacobian(at);
    J.rightCols<3>() *= machine.spread; // the vector code steps by plain rotation vectors
    const Matrix inverse = homeDeterminant != 0.0 ? J.inverse().eval() : Matrix::Zero().eval();
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (int leg = 0; leg < kLegCount; ++leg)
        centre += equations.base(leg);
    centre /= kLegCount;
    for (std::size_t place = 0; place < kLegCount; ++place) {
        const int leg = machine.order[place];
        const Eigen::Vector3d base = equations.base(leg) - centre, joint = equations.joint(leg);
        for (int k = 0; k < 3; ++k) {
            machine.base[static_cast<std::size_t>(k)][placeInMemory(place)] = base[k];
            machine.joint[static_cast<std::size_t>(k)][placeInMemory(place)] = joint[k];
        }
        machine.homeLength[placeInMemory(place)] = at.length[leg];
        for (std::size_t k = 0; k < kLegCount; ++k)
            machine.homeInverse[place][placeInMemory(k)] = inverse(static_cast<Eigen::Index>(k), leg);
    }
    for (auto* rows : {&machine.base, &machine.joint})
        std::ranges::for_each(*rows, repeatLast);
    std::ranges::for_each(machine.homeInverse, repeatLast);
    repeatLast(machine.homeLength);
    for (int k = 0; k < 3; ++k) {
        machine.baseCentroid[static_cast<std::size_t>(k)] = centre[k];
        machine.homeOrigin[static_cast<std::size_t>(k)] = equations.home()[k] - centre[k];
        machine.centroidInP[static_cast<std::size_t>(k)] = equations.centroidInP()[k];
    }
    const double volume = std::pow(machine.spread, 3);
    const double sign = parity(machine.order);
    machine.determinantScale = std::copysign(1.0, homeDeterminant) * sign / volume;
    machine.homeDeterminant = homeDeterminant * sign * volume * at.length.prod();

    if (homeDeterminant == 0.0)
        return machine;
    machine.leastDeterminant = kCertainShare * std::abs(homeDeterminant);
    double slope = 0.0;
    const auto isFree = [&](const PoseVector& end) {
        std::array<double, kLooks> determinants{};
        laneDeterminants(machine, end, determinants.size(), determinants.data());
        bool gone = false;
        double before = 1.0;
        const double look =
            std::hypot(end.head<3>().norm() / machine.size, end.tail<3>().norm() * machine.spread) / kLooks;
        for (const double determinant : determinants) {
            const double part = determinant / std::abs(homeDeterminant);
            slope = std::max(slope, std::abs(part - before) / look);
            before = part;
            if (gone && part > kCertainShare)
                return false;
            gone = gone || !(part > kLostShare);
        }
        return true;
    };
    double scale = 1.0;
    for (int box = 0; box < kMostBoxes; ++box, scale *= kNextBox) {
        const double offset = scale * kOffsetBox * machine.size, angle = scale * kAngleBox;
        bool good = true;
        slope = 0.0;
        for (int corner = 0; good && corner < 1 << 6; ++corner) {
            PoseVector end;
            for (int k = 0; k < 6; ++k)
                end[k] = ((corner >> k & 1) != 0 ? 1.0 : -1.0) * (k < 3 ? offset : angle);
            good = isFree(end);
        }
        PoseSamples samples(1.0, 1.0, kSeed, 0);
        for (int i = 0; good && i < kRays; ++i) {
            PoseVector end = samples.next().toVector();
            end /= end.cwiseAbs().maxCoeff();
            end.head<3>() *= offset;
            end.tail<3>() *= angle;
            good = isFree(end);
        }
        if (!good)
            continue;
        machine.offsetBox = offset;
        machine.angleBox = angle;
        machine.determinantSlope = slope * std::abs(homeDeterminant);
        break;
    }
    return machine;
}

} // namespace hexapose
