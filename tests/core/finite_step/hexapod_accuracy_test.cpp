// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// How near the integrated pose comes, on the laboratory platform, straight leg paths from home.
#include "tests/core/finite_step/finite_step_fixture.h"

#include <gtest/gtest.h>

#include <ostream>

namespace hexapose::testing::accuracy_test {
namespace {

/// Of the errors found independently of this implementation.
constexpr double kPart = 0.05;
constexpr double kOrderTolerance = 0.1;

struct Row {
    const char* name;
    StepForm form;
    int steps;
    double mm;
    double deg;
    friend void PrintTo(const Row& row, std::ostream* out) { *out << row.name << ' ' << row.steps; }
};

class AccuracyTable : public ::testing::TestWithParam<Row> {};

TEST_P(AccuracyTable, OfASecondTargetIsThatOfThePrototype) {
    const Row& row = GetParam();
    const PathError error = straightError(laboratoryAtJoints(), kTarget2, row.steps, row.form);
    EXPECT_NEAR(error.mm / row.mm, 1.0, kPart) << error.mm;
    EXPECT_NEAR(error.deg / row.deg, 1.0, kPart) << error.deg;
}

INSTANTIATE_TEST_SUITE_P(Forms, AccuracyTable,
                         ::testing::Values(Row{"open", StepForm::Open, 10, 1.20, 1.43},
                                           Row{"open", StepForm::Open, 100, 0.123, 0.151},
                                           Row{"open", StepForm::Open, 1000, 1.23e-2, 1.52e-2},
                                           Row{"closed", StepForm::Closed, 10, 0.147, 0.199},
                                           Row{"closed", StepForm::Closed, 100, 1.53e-3, 2.12e-3},
                                           Row{"closed", StepForm::Closed, 1000, 1.53e-5, 2.13e-5},
                                           Row{"corrected", StepForm::Corrected, 10, 2.4e-4, 1.6e-4},
                                           Row{"corrected", StepForm::Corrected, 100, 3.2e-8, 2.1e-8}),
                         [](const auto& which) {
                             return std::string(which.param.name) + std::to_string(which.param.steps);
                         });

TEST(Accuracy, OfAFirstTargetIsThatOfThePrototype) {
    for (const auto& [steps, mm] : {std::pair{10, 0.172}, {100, 1.73e-2}, {1000, 1.73e-3}})
        EXPECT_NEAR(straightError(laboratoryAtJoints(), kTarget1, steps, StepForm::Open).mm / mm, 1.0, kPart);
}

/// The paper quotes 0.2 um at 4500 steps (section 5.2), of a target that it does not print.
TEST(Accuracy, IsThePapersAt4500Steps) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const PathResult result =
        LegPath(machine).followStraight(Pose{}, legLengths(machine, kTarget1), 4500, StepForm::Open);
    const PoseErrors errors = poseErrors(bodyAt(machine, result.pose), bodyAt(machine, kTarget1));
    const Eigen::Vector3d um = 1e6 * errors.position.cwiseAbs();
    EXPECT_NEAR(um[0] / 0.31, 1.0, kPart);
    EXPECT_NEAR(um[1] / 0.11, 1.0, kPart);
    EXPECT_NEAR(um[2] / 0.20, 1.0, kPart);
}

double order(const PlatformGeometry& machine, const Pose& target, StepForm form, int steps) {
    const PathError coarse = straightError(machine, target, steps, form);
    const PathError fine = straightError(machine, target, 2 * steps, form);
    return std::log2(coarse.mm / fine.mm);
}

TEST(Accuracy, HasTheOrderOfItsForm) {
    for (const PlatformGeometry& machine : {laboratoryAtJoints(), octahedral(), asymmetric()}) {
        SCOPED_TRACE(machine.name);
        const double size = machine.size() / laboratory().size();
        Pose target = poseMmDeg(25, -15, 30, 8, -9, 12);
        target.offset *= size;
        EXPECT_NEAR(order(machine, target, StepForm::Open, 800), 1.0, kOrderTolerance);
        EXPECT_NEAR(order(machine, target, StepForm::Closed, 400), 2.0, kOrderTolerance);
        EXPECT_NEAR(order(machine, target, StepForm::Corrected, 40), 4.0, kOrderTolerance);
    }
}

TEST(Accuracy, DoesNotDependOnTheMachinesSize) {
    const PathError small = straightError(laboratoryAtJoints(), kTarget2, 50, StepForm::Closed);
    const double factor = 1e4;
    const PlatformGeometry giant = scaledBy(factor, laboratoryAtJoints());
    Pose target = kTarget2;
    target.offset *= factor;
    const PathError large = straightError(giant, target, 50, StepForm::Closed);
    EXPECT_NEAR(large.mm / (factor * small.mm), 1.0, 1e-6);
    EXPECT_NEAR(large.deg / small.deg, 1.0, 1e-6);
}

TEST(ErrorModel, TellsTheAnglesOfTheAxesAndTheShift) {
    BodyMotion exact, computed;
    constexpr double kSmall = 1e-9; // an arc cosine would lose it
    computed.R_BP = rotationMatrix({0.0, 0.0, kSmall});
    computed.p_OP_B = {1e-3, -2e-3, 0.5e-3};
    const PoseErrors errors = poseErrors(computed, exact);
    EXPECT_NEAR(errors.posture[0], kSmall, 1e-6 * kSmall);
    EXPECT_NEAR(errors.posture[1], kSmall, 1e-6 * kSmall);
    EXPECT_EQ(errors.posture[2], 0.0);
    EXPECT_NEAR(errors.turn, kSmall, 1e-6 * kSmall);
    EXPECT_EQ(errors.position, computed.p_OP_B);
}

} // namespace
} // namespace hexapose::testing::accuracy_test
