// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// A hundred thousand poses at once, on the vector unit and on two threads: 02_batch PLATFORM.toml

#include <hexapose/core/base/input_error.h>
#include <hexapose/core/base/units.h>
#include <hexapose/core/geometry/geometry_file.h>
#include <hexapose/core/kinematics/inverse_kinematics.h>
#include <hexapose/core/kinematics/newton/newton_raphson.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <random>
#include <vector>

int main(int argc, char* argv[]) try {
    if (argc != 2) {
        std::cerr << "usage: 02_batch PLATFORM.toml\n";
        return 2;
    }
    const hexapose::PlatformGeometry platform = hexapose::loadPlatform(argv[1]);
    const hexapose::NewtonRaphson newton(platform, {});

    std::mt19937 random(1);
    std::uniform_real_distribution<double> offset(-0.040, 0.040);
    std::uniform_real_distribution<double> angle(hexapose::radiansFromDeg(-40.0),
                                                 hexapose::radiansFromDeg(40.0));
    std::vector<hexapose::Pose> poses(100000);
    std::vector<hexapose::LegLengths> lengths;
    for (hexapose::Pose& pose : poses) {
        pose = {{offset(random), offset(random), offset(random)},
                {angle(random), angle(random), angle(random)}};
        lengths.push_back(hexapose::legLengths(platform, pose));
    }

    std::vector<hexapose::ForwardResult> results(lengths.size());
    const auto begin = std::chrono::steady_clock::now();
    newton.solveAll(lengths, results, 2);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;

    std::size_t right = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const double error = (results[i].pose.toVector() - poses[i].toVector()).cwiseAbs().maxCoeff();
        right += results[i].isUsable() && error < 1e-8 ? 1 : 0;
    }
    std::cout << right << " of " << poses.size() << " poses found again, "
              << time.count() / static_cast<double>(poses.size()) << " us each\n";
    return right == poses.size() ? 0 : 1;
} catch (const hexapose::InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
