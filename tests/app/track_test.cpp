// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// hexapose-cli track, and forward --method fsi: what comes out, and when they stop.
#include "tests/app/machine.h"
#include "tests/app/process.h"
#include "tests/app/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace hexapose::apptest {
namespace {

using testing::HasSubstr;

double largest(const Outcome& outcome, const std::string& quantity) {
    const Table table(outcome.out);
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        if (table.field(row, "quantity") == quantity)
            return table.number(row, "largest_error");
    ADD_FAILURE() << "no " << quantity << " in\n" << outcome.out;
    return 0.0;
}

TEST(Track, EveryShippedMechanismFollowsItsReference) {
    for (const std::string mechanism : {"6-ups", "3-ups-s", "6-pus", "6-rus", "3-rps"}) {
        SCOPED_TRACE(mechanism);
        const Scratch scratch;
        const Outcome outcome = cli({"track", "--drive", "reference", "--steps", "400", "--out",
                                     scratch.path("new/out"), "--mechanism", mechanism});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        EXPECT_LT(largest(outcome, "position"), 1e-2);
        EXPECT_LT(largest(outcome, "acceleration"), 1e-1);
        const Table table(readText(scratch.path("new/out/tracking.csv")));
        ASSERT_EQ(table.rows.size(), 401U);
        EXPECT_EQ(table.number(400, "time_s"), 2.0);
        EXPECT_EQ(table.field(400, "status"), "ok");
        EXPECT_NEAR(table.number(0, "x_mm"), 0.0, 1e-9);
        EXPECT_GT(table.number(200, "q"), 0.0);
        for (const char* column :
             {"velocity_x_mm_per_s", "angular_acceleration_z_deg_per_s2", "error_position_y_mm",
              "error_posture_z_deg", "error_angular_velocity_x_deg_per_s"})
            EXPECT_TRUE(std::isfinite(table.number(399, column))) << column;
        EXPECT_TRUE(readText(scratch.path("new/out/tracking.png")).starts_with("\x89PNG"));
        EXPECT_THAT(readText(scratch.path("new/out/tracking.svg")), HasSubstr("angular acceleration error"));
    }
}

TEST(Track, ATableOfTheFoldStopsBeforeItAndSaysWhere) {
    const Scratch scratch;
    const Machine machine = laboratory();
    const Six home = machine.lengths({});
    std::string drive = "time_s,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n0";
    for (const double length : home)
        drive += "," + shortest(length);
    drive += "\n1,400,320,400,320,400,320\n";
    const Outcome outcome = cli({"track", "--drive", scratch.file("fold.csv", drive), "--steps", "500",
                                 "--out", scratch.path("out"), "--platform", "laboratory"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(notOneLineWith(outcome.err, {"singular", "of 500", "smallest singular value", "pose"}), "");
    const Table table(readText(scratch.path("out/tracking.csv")));
    const std::size_t last = table.rows.size() - 1;
    EXPECT_EQ(table.field(last, "status"), "singular");
    EXPECT_EQ(table.field(last - 1, "status"), "ok");
    EXPECT_LT(table.number(last, "time_s"), 0.9518);
    EXPECT_GT(table.number(last, "time_s"), 0.85);
}

/// Lengths of a motion by the textbook's formula, as a recording would have them: the rates are found from
/// them.
TEST(Track, FindsTheMotionBehindATableOfLengths) {
    const Scratch scratch;
    const Machine machine = laboratory();
    const auto poseAt = [](double t) {
        return Six{12 * std::sin(t),      -9 * std::sin(1.3 * t), 15 * std::sin(0.8 * t),
                   5 * std::sin(1.1 * t), -6 * std::sin(0.9 * t), 8 * std::sin(t)};
    };
    std::string drive = "time_s,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n";
    for (int k = 0; k <= 200; ++k) {
        drive += shortest(0.01 * k);
        for (const double length : machine.lengths(poseAt(0.01 * k)))
            drive += "," + shortest(length);
        drive += "\n";
    }
    const Outcome outcome =
        cli({"track", "--drive", scratch.file("drive.csv", drive), "--steps", "200", "--form", "corrected",
             "--platform", "laboratory", "--out", scratch.path("out")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const Table table(readText(scratch.path("out/tracking.csv")));
    ASSERT_EQ(table.rows.size(), 201U);
    for (std::size_t row = 0; row < 201; row += 20) {
        const double t = table.number(row, "time_s");
        const Six pose = poseAt(t);
        for (std::size_t k = 0; k < 6; ++k)
            EXPECT_NEAR(table.number(row, poseColumns()[k]), pose[k], 1e-7);
        EXPECT_NEAR(table.number(row, "velocity_x_mm_per_s"), 12 * std::cos(t), 1e-5);
        EXPECT_NEAR(table.number(row, "acceleration_x_mm_per_s2"), -12 * std::sin(t), 1e-3);
    }
}

TEST(Track, AMechanismOfOnesOwnTakesAFile) {
    const Scratch scratch;
    const std::string tripod = scratch.file("tripod.toml", R"(format = 1
name = "Tripod"
output = { position_mm = [0, 0, 100], turns = false }
fixed = [ { name = "A1", position_mm = [100, 0, 0] }, { name = "A2", position_mm = [-50, 80, 0] },
          { name = "A3", position_mm = [-50, -80, 0] } ]
node = [ { name = "B", home_mm = [0, 0, 100] } ]
actuator = [
  { name = "a", kind = "ups", base = "A1", node = "B", reference = { amplitude_mm = 20, rate_deg_per_s = 90 } },
  { name = "b", kind = "ups", base = "A2", node = "B" },
  { name = "c", kind = "pus", node = "B", slider_mm = [-50, -80, 0], direction = [0, 0, 2] } ]
)");
    const Outcome outcome = cli({"track", "--drive", "reference", "--steps", "100", "--mechanism", tripod,
                                 "--out", scratch.path("out")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const Table table(readText(scratch.path("out/tracking.csv")));
    const double x = table.number(50, "x_mm") - 100, y = table.number(50, "y_mm"),
                 z = table.number(50, "z_mm") + 100;
    EXPECT_NEAR(std::sqrt(x * x + y * y + z * z), std::sqrt(20000.0) + 20, 1e-2);
    EXPECT_EQ(table.number(50, "gamma_deg"), 0.0);
}

TEST(ForwardByFiniteSteps, ComesBackToThePose) {
    const Machine machine = laboratory();
    const std::vector<Six> poses = machine.poses(20, 20, 15, 3);
    std::vector<Six> lengths;
    for (const Six& pose : poses)
        lengths.push_back(machine.lengths(pose));
    const std::string input = csv(lengthColumns(), lengths);
    for (const auto& [form, mm] : {std::pair{"open", 0.2}, {"closed", 1e-3}, {"corrected", 1e-7}}) {
        const Outcome outcome =
            cli({"forward", "-", "--method", "fsi", "--steps", "300", "--form", form}, input);
        EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
        const Table table(outcome.out);
        ASSERT_EQ(table.rows.size(), poses.size());
        for (std::size_t row = 0; row < poses.size(); ++row) {
            EXPECT_EQ(table.field(row, "status"), "converged");
            EXPECT_EQ(table.field(row, "iterations"), "300");
            for (std::size_t k = 0; k < 6; ++k)
                EXPECT_NEAR(table.number(row, poseColumns()[k]), poses[row][k], mm);
        }
    }
}

TEST(ForwardByFiniteSteps, StopsBeforeASingularPoseWithThePoseReached) {
    const Outcome outcome =
        cli({"forward", "-", "--method", "fsi", "--steps", "1000", "--details"},
            "l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n400,320,400,320,400,320\n1,2,3,4,5,x\n");
    EXPECT_EQ(outcome.status, 1);
    const Table table(outcome.out);
    EXPECT_EQ(table.field(0, "status"), "singular");
    EXPECT_GT(table.number(0, "iterations"), 850);
    EXPECT_LT(table.number(0, "iterations"), 953);
    EXPECT_GT(table.number(0, "residual_mm"), 1.0);
    EXPECT_GT(table.number(0, "smallest_singular_value"), 0.0);
    EXPECT_LT(table.number(0, "smallest_singular_value"), 0.3);
    EXPECT_TRUE(std::isfinite(table.number(0, "z_mm")));
    EXPECT_EQ(table.field(1, "status"), "invalid-input");
    EXPECT_EQ(table.field(1, "z_mm"), "");
}

} // namespace
} // namespace hexapose::apptest
