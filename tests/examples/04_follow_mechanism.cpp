// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Any mechanism that a file describes, along a drive, and a platform as one:
// 04_follow_mechanism MECHANISM.toml PLATFORM.toml

#include <hexapose/core/base/input_error.h>
#include <hexapose/core/finite_step/drive_path.h>
#include <hexapose/core/finite_step/mechanism_file.h>
#include <hexapose/core/finite_step/motion_tracking.h>
#include <hexapose/core/finite_step/step_system.h>
#include <hexapose/core/geometry/geometry_file.h>

#include <algorithm>
#include <iostream>

int main(int argc, char* argv[]) try {
    if (argc != 3) {
        std::cerr << "usage: 04_follow_mechanism MECHANISM.toml PLATFORM.toml\n";
        return 2;
    }
    // Refused, with the equation that is to blame, when the equations do not determine the motion.
    const hexapose::StepSystem system(hexapose::loadMechanism(argv[1]), argv[1]);
    std::cout << system.mechanism().name << ": " << system.unknowns() << " unknowns, condition "
              << system.homeCondition() << " at home\n";

    const hexapose::ReferenceDrive drive(system.mechanism(), 2.0); // s, of the mechanism's own file
    hexapose::TrackOptions options;
    options.steps = 500;
    options.form = hexapose::StepForm::Corrected;
    const hexapose::Track track = hexapose::trackMotion(system, drive, options);

    double largest = 0.0; // of the output point, against Newton's iteration
    for (const hexapose::TrackRow& row : track.rows)
        largest = std::max(largest, (row.computed.p_OP_B - row.exact.p_OP_B).norm());
    std::cout << track.rows.size() - 1 << " steps, largest error of the output point " << largest << " m\n";

    // A platform is a mechanism too: six legs, three rigid distances, four points.
    const hexapose::StepSystem platform(hexapose::mechanismOf(hexapose::loadPlatform(argv[2])), argv[2]);
    std::cout << "platform: " << platform.unknowns() << " unknowns, condition " << platform.homeCondition()
              << '\n';
    return !track.isSingular && largest < 1e-9 && platform.unknowns() == 12 && platform.homeCondition() < 10.0
               ? 0
               : 1;
} catch (const hexapose::InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
