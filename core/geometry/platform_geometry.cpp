// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/geometry/platform_geometry.h"

#include "core/base/fnv1a.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/geometry/singular_values.h"

#include <array>
#include <charconv>
#include <cmath>

namespace hexapose {

namespace {

/// Joints nearer than this, relative to the spread of all of them, count as one point.
constexpr double kCoincident = 1e-9;

using Points = Eigen::Matrix<double, 3, kLegCount>;

/// Nine digits: what a person wrote, without the rounding of the change of units.
std::string mm(double metres) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), mmFromMetres(metres),
                                   std::chars_format::general, 9)
                         .ptr;
    return {text.data(), end};
}
std::string legName(int leg) {
    return "leg " + std::to_string(leg);
}

Points jointPoints(const PlatformGeometry& geometry, Eigen::Vector3d Leg::*joint) {
    Points points;
    for (int i = 0; i < kLegCount; ++i)
        points.col(i) = geometry.legs[static_cast<std::size_t>(i)].*joint;
    return points;
}

double spread(const Points& points) {
    return (points.colwise() - points.rowwise().mean()).colwise().norm().maxCoeff();
}

bool isCollinear(const Points& points) {
    const Points centred = points.colwise() - points.rowwise().mean();
    const Eigen::Vector3d extents = singularValues(Eigen::MatrixXd(centred));
    return !(extents[1] > kCoincident * extents[0]);
}

void addNonFinite(const PlatformGeometry& geometry, std::vector<GeometryFault>& faults) {
    const auto check = [&](int leg, const char* key, double value, const std::string& what) {
        if (!std::isfinite(value))
            faults.push_back({leg, key, what + " is " + formatNumber(value) + ", not a finite number"});
    };
    for (int k = 0; k < 3; ++k)
        check(0, "position_mm", geometry.p_OP_home_B[k], "home: position_mm[" + std::to_string(k) + "]");
    for (int i = 1; i <= kLegCount; ++i) {
        const Leg& leg = geometry.legs[static_cast<std::size_t>(i - 1)];
        for (int k = 0; k < 3; ++k) {
            check(i, "base_mm", leg.p_OA_B[k], legName(i) + ": base_mm[" + std::to_string(k) + "]");
            check(i, "platform_mm", leg.p_PB_P[k], legName(i) + ": platform_mm[" + std::to_string(k) + "]");
        }
        check(i, "min_mm", leg.minLength, legName(i) + ": min_mm");
        check(i, "max_mm", leg.maxLength, legName(i) + ": max_mm");
    }
}

void addStrokeFaults(const PlatformGeometry& geometry, std::vector<GeometryFault>& faults) {
    const LegLengths home = geometry.homeLengths();
    for (int i = 1; i <= kLegCount; ++i) {
        const Leg& leg = geometry.legs[static_cast<std::size_t>(i - 1)];
        const double length = home[i - 1];
        const auto homeLength = [&] { return legName(i) + ": length at home " + mm(length) + " mm"; };
        if (!(leg.minLength > 0.0))
            faults.push_back({i, "min_mm", legName(i) + ": min_mm " + mm(leg.minLength) + " is not above 0"});
        if (!(leg.minLength < leg.maxLength))
            faults.push_back(
                {i, "min_mm",
                 legName(i) + ": min_mm " + mm(leg.minLength) + " is not below max_mm " + mm(leg.maxLength)});
        else if (!(length > 0.0 && std::isfinite(length)))
            faults.push_back({i, "base_mm", homeLength() + " is not a positive number"});
        else if (length < leg.minLength)
            faults.push_back({i, "min_mm", homeLength() + " is below min_mm " + mm(leg.minLength)});
        else if (length > leg.maxLength)
            faults.push_back({i, "max_mm", homeLength() + " is above max_mm " + mm(leg.maxLength)});
    }
}

void addJointFaults(const PlatformGeometry& geometry, std::vector<GeometryFault>& faults) {
    const Points base = jointPoints(geometry, &Leg::p_OA_B);
    const Points platform = jointPoints(geometry, &Leg::p_PB_P);
    const double baseNear = kCoincident * spread(base), platformNear = kCoincident * spread(platform);
    for (int i = 0; i < kLegCount; ++i)
        for (int j = i + 1; j < kLegCount; ++j)
            if ((base.col(i) - base.col(j)).norm() <= baseNear &&
                (platform.col(i) - platform.col(j)).norm() <= platformNear)
                faults.push_back({j + 1, "base_mm",
                                  legName(j + 1) +
                                      ": coincident joints, base_mm and platform_mm are those of leg " +
                                      std::to_string(i + 1)});
    const auto lineFault = [&](const Points& points, const char* side, const char* key) {
        if (spread(points) == 0.0)
            faults.push_back(
                {1, key, std::string("coincident joints, all ") + side + " joints are one point"});
        else if (isCollinear(points))
            faults.push_back({1, key, std::string("all ") + side + " joints lie on one line"});
    };
    lineFault(base, "base", "base_mm");
    lineFault(platform, "platform", "platform_mm");
}

} // namespace

LegLengths PlatformGeometry::homeLengths() const {
    LegLengths lengths;
    for (int i = 0; i < kLegCount; ++i) {
        const Leg& leg = legs[static_cast<std::size_t>(i)];
        lengths[i] = (p_OP_home_B + leg.p_PB_P - leg.p_OA_B).norm();
    }
    return lengths;
}

double PlatformGeometry::size() const {
    return homeLengths().mean();
}

double PlatformGeometry::jointRadius() const {
    double sum = 0.0;
    for (const Leg& leg : legs)
        sum += leg.p_PB_P.squaredNorm();
    return std::sqrt(sum / kLegCount);
}

std::string PlatformGeometry::fingerprint() const {
    Fnv1a hash;
    const auto add = [&](const Eigen::Vector3d& point) {
        for (int k = 0; k < 3; ++k)
            hash.add(point[k]);
    };
    add(p_OP_home_B);
    for (const Leg& leg : legs) {
        add(leg.p_OA_B);
        add(leg.p_PB_P);
    }
    return hash.hex();
}

std::vector<GeometryFault> findFaults(const PlatformGeometry& geometry) {
    std::vector<GeometryFault> faults;
    addNonFinite(geometry, faults);
    if (!faults.empty())
        return faults; // nothing can be computed from them
    addStrokeFaults(geometry, faults);
    addJointFaults(geometry, faults);
    return faults;
}

std::vector<std::string> validate(const PlatformGeometry& geometry) {
    std::vector<std::string> sentences;
    for (const GeometryFault& fault : findFaults(geometry))
        sentences.push_back(fault.text);
    return sentences;
}

} // namespace hexapose
