// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// The mechanisms that come with the program, and others, from their files alone.
#include "core/finite_step/node_path.h"
#include "tests/core/finite_step/finite_step_fixture.h"

#include <gtest/gtest.h>

namespace hexapose::testing::steps_test {
namespace {

constexpr double kOrderTolerance = 0.1;
constexpr double kPart = 0.05; ///< of errors found independently of this implementation

Eigen::VectorXd follow(const StepSystem& system, const Eigen::VectorXd& target, int steps, StepForm form) {
    const StraightDrive drive(system.homeDrive(), target);
    NodePath path(system, drive, steps, form, system.homeNodes());
    while (path.advance()) {
    }
    EXPECT_FALSE(path.isSingular()) << system.mechanism().name << " at " << path.step();
    return path.nodes();
}

/// Every actuator by its reference amplitude: a target of ordinary size.
Eigen::VectorXd targetOf(const StepSystem& system) {
    Eigen::VectorXd target = system.homeDrive();
    for (Eigen::Index i = 0; i < target.size(); ++i)
        target[i] += system.mechanism().actuators[static_cast<std::size_t>(i)].referenceAmplitude;
    return target;
}

class ShippedMechanism : public ::testing::TestWithParam<const char*> {
protected:
    const StepSystem m_system = shippedSystem(GetParam());
};

TEST_P(ShippedMechanism, HasTheOrderOfItsForm) {
    const Eigen::VectorXd target = targetOf(m_system);
    Eigen::VectorXd exact = follow(m_system, target, 2000, StepForm::Corrected), shift = exact;
    StepWorkspace memory = m_system.workspace();
    ASSERT_TRUE(solveNodes(m_system, target, memory, shift, exact));
    EXPECT_LT(m_system.residual(exact, target, memory), 1e-14);
    const auto error = [&](int steps, StepForm form) {
        return (follow(m_system, target, steps, form) - exact).norm();
    };
    for (const auto& [form, steps, expected] : {std::tuple{StepForm::Open, 800, 1.0},
                                                {StepForm::Closed, 400, 2.0},
                                                {StepForm::Corrected, 25, 4.0}}) {
        const double order = std::log2(error(steps, form) / error(2 * steps, form));
        EXPECT_NEAR(order, expected, kOrderTolerance) << toWord(form);
    }
}

TEST_P(ShippedMechanism, ItsStepMatrixIsTheDerivativeOfItsConstraints) {
    const Eigen::VectorXd drive = 0.5 * (targetOf(m_system) + m_system.homeDrive());
    const Eigen::VectorXd nodes = follow(m_system, drive, 100, StepForm::Corrected);
    StepWorkspace memory = m_system.workspace();
    Eigen::VectorXd shift = nodes;
    // One exact Newton step takes an error away to second order.
    Eigen::VectorXd off = nodes;
    for (Eigen::Index i = 0; i < off.size(); ++i)
        off[i] += 1e-6 * std::sin(1.0 + static_cast<double>(i));
    m_system.step(off, drive, drive, StepSide::Correction, memory, shift);
    EXPECT_LT((off + shift - nodes).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Files, ShippedMechanism,
                         ::testing::Values("6-ups", "3-ups-s", "6-pus", "6-rus", "3-rps"),
                         [](const auto& which) {
                             std::string name = which.param;
                             for (char& c : name)
                                 c = c == '-' ? '_' : c;
                             return name;
                         });

TEST(Mechanism, TheSixUpsFileIsTheLaboratoryPlatform) {
    const Mechanism file = loadMechanism(mechanismFile("6-ups"));
    const Mechanism made = mechanismOf(laboratoryAtJoints());
    ASSERT_EQ(file.points.size(), made.points.size());
    for (std::size_t i = 0; i < file.points.size(); ++i) {
        EXPECT_EQ(file.points[i].name, made.points[i].name);
        EXPECT_LT((file.points[i].home_B - made.points[i].home_B).norm(), 1e-15);
    }
}

/// The fixed-size core and the assembled system are one and the same, also where joints are out of plane.
TEST(Mechanism, TheHexapodCoreIsTheAssembledSystem) {
    for (const PlatformGeometry& machine : {laboratoryAtJoints(), octahedral(), asymmetric()}) {
        SCOPED_TRACE(machine.name);
        const StepSystem system(mechanismOf(machine), machine.name);
        const HexapodSteps core{PlatformModel(machine)};
        Pose target = poseMmDeg(20, -10, 25, 10, -8, 12);
        target.offset *= machine.size() / 0.3;
        const LegLengths home = machine.homeLengths(), change = legLengths(machine, target) - home;
        for (const StepSide side : {StepSide::Drive, StepSide::Closed}) {
            HexapodSteps::Marks marks = core.marksAt(Pose{});
            Eigen::VectorXd nodes = system.homeNodes(), shift = nodes;
            StepWorkspace memory = system.workspace();
            for (int k = 0; k < 20; ++k) {
                const LegLengths from = home + k / 20.0 * change, to = home + (k + 1) / 20.0 * change;
                const double q = system.step(nodes, from, to, side, memory, shift);
                nodes += shift;
                EXPECT_NEAR(core.step(marks, from, to, side), q, 1e-11);
            }
            const Eigen::VectorXd flat = Eigen::VectorXd::Map(marks.data(), 12);
            // Nodes stand in the order of the legs; so do the marks.
            EXPECT_LT((flat - nodes).norm(), 1e-12 * machine.size());
        }
    }
}

/// Three degrees of freedom about a fixed centre: the lengths that a rotation asks for lead to that rotation.
TEST(Mechanism, SphericalPlatformComesToTheRotation) {
    const StepSystem system = shippedSystem("3-ups-s");
    const Mechanism& mechanism = system.mechanism();
    const Eigen::Matrix3d R = rotationMatrix({radiansFromDeg(10), radiansFromDeg(-8), radiansFromDeg(12)});
    const Eigen::Vector3d centre = mechanism.output.p_OP_home_B;
    Eigen::VectorXd target(3);
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Actuator& leg = mechanism.actuators[static_cast<std::size_t>(i)];
        target[i] =
            (centre + R * (mechanism.points[leg.node].home_B - centre) - mechanism.points[leg.base].home_B)
                .norm();
    }
    double before = 0.0;
    for (const int steps : {10, 100, 1000}) {
        const BodyMotion body = poseOfNodes(system, follow(system, target, steps, StepForm::Open));
        const double deg = degFromRadians(rotationVector(R, body.R_BP).norm());
        if (before > 0.0) {
            EXPECT_NEAR(before / deg, 10.0, 0.5);
        } else {
            EXPECT_NEAR(deg / 0.169, 1.0, kPart); // as the prototype
        }
        before = deg;
    }
    for (const auto& [steps, deg] : {std::pair{10, 1.7e-2}, {100, 1.7e-4}, {1000, 1.7e-6}}) {
        const BodyMotion closed = poseOfNodes(system, follow(system, target, steps, StepForm::Closed));
        EXPECT_NEAR(degFromRadians(rotationVector(R, closed.R_BP).norm()) / deg, 1.0, kPart);
    }
    const BodyMotion body = poseOfNodes(system, follow(system, target, 100, StepForm::Corrected));
    EXPECT_LT(rotationVector(R, body.R_BP).norm(), 1e-9);
    EXPECT_LT((body.p_OP_B - centre).norm(), 1e-9);
}

/// A kind of machine that is not among the files: three cranks and parallelograms that keep the platform from
/// turning (Delta). Written here as a user would; nothing is compiled for it.
TEST(Mechanism, ADeltaRobotTakesAFileAndNothingElse) {
    std::string text = "format = 1\nname = \"Delta\"\n[output]\nposition_mm = [0, 0, 200]\n";
    for (int k = 0; k < 3; ++k) {
        const double angle = radiansFromDeg(120.0 * k), c = std::cos(angle), s = std::sin(angle);
        const auto at = [&](double radius, double height) {
            return "[" + std::to_string(radius * c) + ", " + std::to_string(radius * s) + ", " +
                   std::to_string(height) + "]";
        };
        const std::string number = std::to_string(k + 1);
        text += "[[node]]\nname = \"B" + number + "\"\nhome_mm = " + at(50, 200) + "\n";
        text += "[[actuator]]\nname = \"phi" + number + "\"\nkind = \"rus\"\nnode = \"B" + number +
                "\"\ncentre_mm = " + at(100, 0) + "\ncrank_mm = " + at(180, 0) + "\naxis = [" +
                std::to_string(s) + ", " + std::to_string(-c) + ", 0]\n";
    }
    for (const char* other : {"B2", "B3"})
        text += std::string("[[rigid]]\nkind = \"translation\"\npoints = [\"B1\", \"") + other + "\"]\n";
    const StepSystem system(parseMechanism(text, "delta.toml"), "delta.toml");
    EXPECT_EQ(system.unknowns(), 9);
    const Eigen::Vector3d turns(radiansFromDeg(20), radiansFromDeg(-10), radiansFromDeg(5));
    const Eigen::VectorXd nodes = follow(system, turns, 200, StepForm::Corrected);
    const BodyMotion body = poseOfNodes(system, nodes);
    EXPECT_LT((body.R_BP - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    for (std::size_t i = 0; i < 3; ++i) { // each rod is as long as it was
        const Actuator& crank = system.mechanism().actuators[i];
        const Eigen::Vector3d home = system.mechanism().points[crank.node].home_B;
        const auto k = static_cast<Eigen::Index>(i);
        EXPECT_NEAR((nodes.segment<3>(3 * k) - handPosition(crank, turns[k])).norm(),
                    (home - crank.hand_B).norm(), 1e-10);
    }
}

} // namespace
} // namespace hexapose::testing::steps_test
