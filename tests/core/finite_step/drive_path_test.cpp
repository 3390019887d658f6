// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/drive_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hexapose::testing::drive_test {
namespace {

/// Uneven times, as a recording has them.
std::vector<double> someTimes(int count) {
    std::vector<double> times;
    for (int i = 0; i < count; ++i)
        times.push_back(-0.3 + 0.1 * i + 0.02 * std::sin(3.0 * i));
    return times;
}

TableDrive::Samples samplesOf(const std::vector<double>& times, double (*value)(double)) {
    TableDrive::Samples samples{times, {{}}, false};
    for (const double time : times)
        samples.states[0].push_back({value(time), 0.0, 0.0});
    return samples;
}

DriveState stateAt(const DrivePath& drive, double time) {
    DriveState state;
    drive.at(time, {&state, 1});
    return state;
}

TEST(TableDrive, APolynomialOfDegreeFiveIsExact) {
    const auto value = [](double t) { return 1.0 - 2.0 * t + t * t * t - 0.5 * std::pow(t, 5); };
    const TableDrive drive(samplesOf(someTimes(12), value));
    for (double t = drive.begin(); t <= drive.end(); t += 0.013) {
        const DriveState state = stateAt(drive, t);
        EXPECT_NEAR(state.value, value(t), 1e-12);
        EXPECT_NEAR(state.rate, -2.0 + 3.0 * t * t - 2.5 * std::pow(t, 4), 1e-10);
        EXPECT_NEAR(state.acceleration, 6.0 * t - 10.0 * std::pow(t, 3), 1e-8);
    }
}

TEST(TableDrive, GivenRatesAreMet) {
    TableDrive::Samples samples{{0.0, 0.5, 2.0}, {{}}, true};
    for (const double t : samples.times)
        samples.states[0].push_back({std::sin(t), std::cos(t), -std::sin(t)});
    const TableDrive drive(samples);
    for (const double t : samples.times) {
        const DriveState state = stateAt(drive, t);
        EXPECT_NEAR(state.value, std::sin(t), 1e-14);
        EXPECT_NEAR(state.rate, std::cos(t), 1e-14);
        EXPECT_NEAR(state.acceleration, -std::sin(t), 1e-13);
    }
    EXPECT_NEAR(stateAt(drive, 1.2).value, std::sin(1.2), 1e-3);
}

TEST(TableDrive, FewSamplesGiveTheirPolynomial) {
    const TableDrive line({{1.0, 3.0}, {{{10.0, 0, 0}, {14.0, 0, 0}}}, false});
    EXPECT_NEAR(stateAt(line, 2.5).value, 13.0, 1e-14);
    EXPECT_NEAR(stateAt(line, 2.5).rate, 2.0, 1e-14);
    EXPECT_NEAR(stateAt(line, 2.5).acceleration, 0.0, 1e-13);
    const TableDrive parabola(samplesOf({0.0, 1.0, 4.0}, [](double t) { return t * t; }));
    EXPECT_NEAR(stateAt(parabola, 3.0).value, 9.0, 1e-13);
    EXPECT_NEAR(stateAt(parabola, 3.0).acceleration, 2.0, 1e-12);
}

TEST(StraightDrive, EndsAtItsTarget) {
    const StraightDrive drive(Eigen::VectorXd::Constant(1, 0.1), Eigen::VectorXd::Constant(1, 0.7));
    EXPECT_EQ(stateAt(drive, 0.0).value, 0.1);
    EXPECT_EQ(stateAt(drive, 1.0).value, 0.7);
    EXPECT_NEAR(stateAt(drive, 0.5).value, 0.4, 1e-15);
    EXPECT_NEAR(stateAt(drive, 0.5).rate, 0.6, 1e-15);
}

} // namespace
} // namespace hexapose::testing::drive_test
