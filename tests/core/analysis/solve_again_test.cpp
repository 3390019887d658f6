// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/analysis/solve_again.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/geometry/geometry_file.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "tests/core/table/table_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hexapose {
namespace {

using testing_support::tableOf;

PlatformGeometry laboratory() {
    return loadPlatform(std::string(HEXAPOSE_SOURCE_DIR) + "/resources/platforms/laboratory.toml");
}

std::string lengthUnits(const std::string& unit) {
    std::string header;
    for (int i = 1; i <= 6; ++i)
        header += "l" + std::to_string(i) + "_" + unit + ",";
    return header;
}

/// A log of a motion: lengths in a unit, poses in mm and deg.
std::string motionLog(const PlatformGeometry& platform, int rows, const std::string& unit, double perMetre) {
    std::string text = "time_s," + lengthUnits(unit) + "x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg,status\n";
    for (int i = 0; i < rows; ++i) {
        const double t = 0.001 * i;
        const Pose pose{{0.01 * std::sin(t), 0.008 * std::cos(t), 0.02 * std::sin(0.7 * t)},
                        {0.1 * std::sin(t), 0.05 * std::cos(1.3 * t), -0.08 * std::sin(t)}};
        text += formatNumber(t);
        const LegLengths lengths = legLengths(platform, pose);
        for (int leg = 0; leg < 6; ++leg)
            text += "," + (i == 7 && leg == 2 ? std::string() : formatNumber(lengths[leg] * perMetre));
        const PoseVector values = pose.toVector();
        for (int k = 0; k < 6; ++k) {
            const double shown = k < 3 ? mmFromMetres(values[k]) : degFromRadians(values[k]);
            text += "," + (i == 7 || i == 9 ? std::string()
                                            : formatNumber(shown + (i == 100 && k == 4 ? 0.001 : 0.0)));
        }
        text += i == 9 ? ",iteration-limit\n" : ",converged\n";
    }
    return text;
}

TEST(SolveAgain, FindsTheRowsThatDiffer) {
    const PlatformGeometry platform = laboratory();
    const NewtonRaphson newton(platform, {});
    for (const auto& [unit, perMetre] :
         {std::pair("mm", 1e3), std::pair("m", 1.0), std::pair("in", 1.0 / 0.0254)}) {
        SCOPED_TRACE(unit);
        const auto table = tableOf(motionLog(platform, 40000, unit, perMetre));
        const auto lengths = findLengths(*table), pose = findMeasuredPose(*table);
        ASSERT_TRUE(lengths && pose);
        SolveAgainOptions one, many;
        one.threads = 1;
        many.threads = 4;
        const SolvedRows solved = solveAgain(*table, *lengths, newton, one);
        ASSERT_EQ(solved.rows.size(), 40000U);
        EXPECT_FALSE(solved.rows[7].hasLengths);
        const auto found = findDisagreements(*table, *pose, solved);
        ASSERT_EQ(found.size(), 2U);
        EXPECT_EQ(found[0].row, 9U);
        EXPECT_FALSE(found[0].column);
        EXPECT_TRUE(found[0].isSolved);
        EXPECT_EQ(found[1].row, 100U);
        EXPECT_EQ(table->columns()[*found[1].column].info().name, "beta_deg");
        EXPECT_NEAR(found[1].recorded - found[1].solved, 0.001, 1e-9);
        const SolvedRows again = solveAgain(*table, *lengths, newton, many);
        for (Row row = 0; row < solved.rows.size(); ++row)
            ASSERT_TRUE(!solved.rows[row].isUsable ||
                        solved.rows[row].pose.toVector() == again.rows[row].pose.toVector());
    }
}

TEST(SolveAgain, StopsWhenAsked) {
    const PlatformGeometry platform = laboratory();
    const NewtonRaphson newton(platform, {});
    const auto table = tableOf(motionLog(platform, 100, "mm", 1e3));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(solveAgain(*table, *findLengths(*table), newton, {1, stop.get_token(), {}}).rows.empty());
}

TEST(SixColumns, NeedAllSixInUnitsThatFit) {
    EXPECT_FALSE(findLengths(*tableOf("l1_mm,l2_mm,l3_mm,l4_mm,l5_mm\n1,2,3,4,5\n")));
    EXPECT_FALSE(findLengths(*tableOf("l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_deg\n1,2,3,4,5,6\n")));
    const auto bare = tableOf("l1,l2,l3,l4,l5,l6\n1,2,3,4,5,6\n");
    const auto found = findLengths(*bare);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ((*lengthsOf(*bare, *found, 0))[5], 0.006);
    const auto radians = tableOf("x_m,y_m,z_m,alpha_rad,beta_rad,gamma [deg]\n1,2,3,4,5,180\n");
    EXPECT_NEAR(poseOf(*radians, *findMeasuredPose(*radians), 0)->angles.gamma, std::numbers::pi, 1e-15);
}

} // namespace
} // namespace hexapose
