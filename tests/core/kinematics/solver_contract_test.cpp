// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// What every forward solver owes, on several machines.
#include "core/kinematics/catalog/forward_methods.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <tuple>

using namespace hexapose;
using namespace hexapose::testing;

namespace {

PlatformGeometry machineNamed(const std::string& name) {
    return name == "octahedral"      ? octahedral()
           : name == "asymmetric"    ? asymmetric()
           : name == "thousandth"    ? scaledBy(1e-3, laboratory())
           : name == "million_times" ? scaledBy(1e6, laboratory())
                                     : laboratory();
}

/// One training for all cases of a machine and a degree.
const PolynomialModel& modelOf(const std::string& machine, int degree) {
    static std::map<std::pair<std::string, int>, PolynomialModel> models;
    const auto key = std::pair{machine, degree};
    if (!models.contains(key)) {
        const PlatformGeometry geometry = machineNamed(machine);
        TrainingSpec spec = defaultTrainingSpec(geometry, degree);
        spec.samples = 20000;
        models[key] = *trainModel(geometry, spec);
    }
    return models[key];
}

using Case = std::tuple<const char*, const char*>; // machine, method

class SolverContract : public ::testing::TestWithParam<Case> {
protected:
    const std::string m_machineName = std::get<0>(GetParam());
    const PlatformGeometry m_machine = machineNamed(m_machineName);
    const ForwardMethod& m_method = *findForwardMethod(std::get<1>(GetParam()));
    const PolynomialModel* m_model =
        m_method.modelDegree == 0 ? nullptr : &modelOf(m_machineName, m_method.modelDegree);
    const std::unique_ptr<ForwardSolver> m_solver = makeForwardSolver(m_method, m_machine, m_model, {});
    const TrainingSpec m_box = modelOf(m_machineName, 3).spec;
    const bool m_iterates = m_method.modelDegree == 0 || m_method.word.ends_with("-nr");
};

} // namespace

TEST_P(SolverContract, FindsThePoseItsLengthsComeFrom) {
    EXPECT_EQ(m_solver->name(), m_method.word);
    RandomPoses poses(0.9 * m_box.offsetRange, 0.9 * m_box.angleRange, 31);
    for (int i = 0; i < 300; ++i) {
        const Pose truth = poses.next();
        const LegLengths lengths = legLengths(m_machine, truth);
        const ForwardResult result = m_solver->solve(lengths, Pose{});
        ASSERT_EQ(result.status, SolveStatus::Converged)
            << toWord(result.status) << ' ' << truth.toVector().transpose();
        EXPECT_TRUE(result.accurate && result.isUsable() && result.hasPose());
        EXPECT_NEAR(result.residual, (lengths - legLengths(m_machine, result.pose)).norm(),
                    1e-14 * m_machine.size());
        if (m_iterates) {
            EXPECT_LE(result.residual, defaultTolerance(m_machine));
            EXPECT_LT(distance(m_machine, result.pose, truth), 1e-7);
        } else {
            EXPECT_EQ(result.iterations, 0);
            EXPECT_LE(result.residual, 2.0 * m_model->maxResidual);
        }
    }
}

TEST_P(SolverContract, RefusesWhatAreNoLengths) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {std::nan(""), infinity, -infinity, 0.0, -0.3 * m_machine.size()})
        for (int leg = 0; leg < kLegCount; ++leg) {
            LegLengths lengths = m_machine.homeLengths();
            lengths[leg] = bad;
            const ForwardResult result = m_solver->solve(lengths, Pose{});
            EXPECT_EQ(result.status, SolveStatus::InvalidInput);
            EXPECT_FALSE(result.hasPose() || result.isUsable() || result.pose.isFinite());
        }
}

TEST_P(SolverContract, NeverCallsAnUnreachableSetUsable) {
    for (const double factor : {1e-3, 30.0, 1e150, 1e300}) {
        LegLengths lengths = m_machine.homeLengths();
        lengths[2] *= factor;
        const ForwardResult one = m_solver->solve(lengths, Pose{});
        EXPECT_FALSE(one.isUsable()) << factor;
        EXPECT_EQ(one.status, m_iterates ? SolveStatus::NoSolution : SolveStatus::OutsideModel)
            << toWord(one.status);
    }
    for (const double factor : {1e150, 1e300}) { // a pose, far up in the sky, but beyond what doubles resolve
        const ForwardResult all = m_solver->solve(factor * m_machine.homeLengths(), Pose{});
        EXPECT_FALSE(all.isUsable()) << toWord(all.status);
        EXPECT_TRUE(!all.hasPose() || all.pose.isFinite()) << factor;
    }
}

TEST_P(SolverContract, AnglesStayInTheirRanges) {
    const Pose home = m_solver->solve(m_machine.homeLengths(), {{}, {6.0, 6.5, -6.1}}).pose;
    EXPECT_LE(std::abs(home.angles.alpha), std::numbers::pi);
    EXPECT_LE(std::abs(home.angles.beta), std::numbers::pi / 2);
    EXPECT_LE(std::abs(home.angles.gamma), std::numbers::pi);
}

INSTANTIATE_TEST_SUITE_P(Machines, SolverContract,
                         ::testing::Combine(::testing::Values("laboratory", "octahedral", "asymmetric",
                                                              "thousandth", "million_times"),
                                            ::testing::Values("newton", "newton-as-published", "mpr2", "mpr3",
                                                              "mpr2-nr", "mpr3-nr")),
                         [](const auto& which) {
                             std::string name =
                                 std::string(std::get<0>(which.param)) + '_' + std::get<1>(which.param);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });
