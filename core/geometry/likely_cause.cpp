// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/geometry/likely_cause.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace hexapose {

namespace {

constexpr double kSimilar = 0.01; ///< ratios of distances that differ by no more are the same

using Undo = std::function<void(PlatformGeometry&)>;

struct Mistake {
    std::string words;
    Undo undo;
};

void rotatePlatformJoints(PlatformGeometry& geometry, int by) {
    const std::array<Leg, kLegCount> before = geometry.legs;
    for (int i = 0; i < kLegCount; ++i)
        geometry.legs[static_cast<std::size_t>(i)].p_PB_P =
            before[static_cast<std::size_t>((i + by + kLegCount) % kLegCount)].p_PB_P;
}

void reversePlatformJoints(PlatformGeometry& geometry) {
    for (std::size_t i = 0; i < kLegCount / 2; ++i)
        std::swap(geometry.legs[i].p_PB_P, geometry.legs[kLegCount - 1 - i].p_PB_P);
}

Undo swapAxes(Eigen::Vector3d Leg::*joint) {
    return [joint](PlatformGeometry& geometry) {
        for (Leg& leg : geometry.legs)
            std::swap((leg.*joint)[0], (leg.*joint)[1]);
    };
}

void moveToPlatformFrame(PlatformGeometry& geometry) {
    for (Leg& leg : geometry.legs)
        leg.p_PB_P -= geometry.p_OP_home_B;
}

Undo scaleJoints(double factor, bool homeToo) {
    return [factor, homeToo](PlatformGeometry& geometry) {
        if (homeToo)
            geometry.p_OP_home_B *= factor;
        for (Leg& leg : geometry.legs) {
            leg.p_OA_B *= factor;
            leg.p_PB_P *= factor;
        }
    };
}

const std::vector<Mistake>& mistakes() {
    static const std::vector<Mistake> all = [] {
        std::vector<Mistake> list{
            {"platform_mm is given in the base frame, not from the platform's origin", moveToPlatformFrame},
            {"platform_mm of each leg belongs to the leg before",
             [](auto& g) { rotatePlatformJoints(g, 1); }},
            {"platform_mm of each leg belongs to the leg after",
             [](auto& g) { rotatePlatformJoints(g, -1); }},
            {"x and y are exchanged in platform_mm", swapAxes(&Leg::p_PB_P)},
            {"x and y are exchanged in base_mm", swapAxes(&Leg::p_OA_B)},
            {"platform_mm is in the opposite order of legs", reversePlatformJoints}};
        constexpr std::pair<const char*, double> kUnits[] = {
            {"inches", 25.4}, {"centimetres", 10.0}, {"metres", 1000.0}};
        for (const auto& [unit, factor] : kUnits) {
            list.push_back(
                {std::string("base_mm and platform_mm are in ") + unit, scaleJoints(factor, false)});
            list.push_back({std::string("base_mm, platform_mm and position_mm are in ") + unit,
                            scaleJoints(factor, true)});
            list.push_back({std::string("min_mm and max_mm are in ") + unit,
                            [factor = factor](PlatformGeometry& geometry) {
                                for (Leg& leg : geometry.legs) {
                                    leg.minLength *= factor;
                                    leg.maxLength *= factor;
                                }
                            }});
        }
        return list;
    }();
    return all;
}

bool homeIsWithinStrokes(const PlatformGeometry& geometry) {
    const LegLengths home = geometry.homeLengths();
    for (int i = 0; i < kLegCount; ++i) {
        const Leg& leg = geometry.legs[static_cast<std::size_t>(i)];
        if (!(home[i] >= leg.minLength && home[i] <= leg.maxLength))
            return false;
    }
    return true;
}

} // namespace

std::string likelyMistake(const PlatformGeometry& geometry,
                          const std::function<bool(const PlatformGeometry&)>& fits) {
    for (const Mistake& mistake : mistakes()) {
        PlatformGeometry corrected = geometry;
        mistake.undo(corrected);
        if (fits(corrected))
            return mistake.words;
    }
    return {};
}

std::string likelyMistakeOfStrokes(const PlatformGeometry& geometry) {
    return homeIsWithinStrokes(geometry) ? std::string() : likelyMistake(geometry, homeIsWithinStrokes);
}

bool areSimilarFigures(const PlatformGeometry& geometry) {
    double smallest = HUGE_VAL;
    double largest = 0.0;
    for (std::size_t i = 0; i < kLegCount; ++i)
        for (std::size_t j = i + 1; j < kLegCount; ++j) {
            const double base = (geometry.legs[i].p_OA_B - geometry.legs[j].p_OA_B).norm();
            const double platform = (geometry.legs[i].p_PB_P - geometry.legs[j].p_PB_P).norm();
            smallest = std::min(smallest, platform / base);
            largest = std::max(largest, platform / base);
        }
    return largest <= smallest * (1.0 + kSimilar);
}

} // namespace hexapose
