// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// inverse and forward as other programs call them, on several machines.
#include "tests/app/machine.h"
#include "tests/app/process.h"
#include "tests/app/scratch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>

namespace hexapose::apptest {
namespace {

const std::string kPublished = "l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n339.5,336.5,336.6,329.2,345.1,334.5\n";

double radians(const Table& table, const char* column) {
    return table.number(0, column) * std::numbers::pi / 180.0;
}

TEST(Forward, PublishedLengthsGiveThePublishedPose) {
    for (const char* method : {"newton", "newton-as-published", "mpr2-nr", "mpr3-nr", ""}) {
        SCOPED_TRACE(method);
        std::vector<std::string> words{"forward", "-"};
        if (*method != '\0')
            words.insert(words.end(), {"--method", method});
        const Outcome outcome = cli(words, kPublished);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        const Table table(outcome.out);
        ASSERT_EQ(table.rows.size(), 1U);
        // Half of the last digit that is printed.
        EXPECT_NEAR(radians(table, "alpha_deg"), -1.686e-4, 0.5e-7);
        EXPECT_NEAR(radians(table, "beta_deg"), 5.838e-5, 0.5e-8);
        EXPECT_NEAR(radians(table, "gamma_deg"), 0.08689, 0.5e-5);
        EXPECT_NEAR(table.number(0, "x_mm"), 11.99, 0.5e-2);
        EXPECT_NEAR(table.number(0, "y_mm"), -4.04, 0.5e-2);
        EXPECT_NEAR(table.number(0, "z_mm"), 39.78, 0.5e-2);
        EXPECT_EQ(table.field(0, "status"), "converged");
        EXPECT_LT(table.number(0, "residual_mm"), 1e-6);
        EXPECT_GE(table.number(0, "iterations"), 0.0);
    }
    // The regressions alone: near, and honest about how near.
    for (const char* method : {"mpr2", "mpr3"}) {
        SCOPED_TRACE(method);
        const Table table(cli({"forward", "-", "--method", method}, kPublished).out);
        EXPECT_NEAR(radians(table, "gamma_deg"), 0.08689, 2e-2);
        EXPECT_NEAR(table.number(0, "z_mm"), 39.78, 3.0);
        EXPECT_EQ(table.field(0, "iterations"), "0");
        Six pose{};
        for (std::size_t k = 0; k < 6; ++k)
            pose[k] = table.number(0, poseColumns()[k]);
        const Six legs = laboratory().lengths(pose);
        const Six given{339.5, 336.5, 336.6, 329.2, 345.1, 334.5};
        double square = 0.0;
        for (std::size_t k = 0; k < 6; ++k)
            square += std::pow(legs[k] - given[k], 2);
        EXPECT_NEAR(table.number(0, "residual_mm"), std::sqrt(square), 1e-9);
    }
}

TEST(Forward, EveryMethodReportsASingularPlatformInItsRows) {
    // Both rings the same hexagon, one half as large: it can move while its legs stand still.
    Machine hexagons = laboratory();
    for (std::size_t i = 0; i < 6; ++i) {
        const double angle = static_cast<double>(i) * std::numbers::pi / 3.0;
        hexagons.base[i] = {180.0 * std::cos(angle), 180.0 * std::sin(angle), 0.0};
        for (std::size_t k = 0; k < 3; ++k)
            hexagons.platform[i][k] = 0.5 * hexagons.base[i][k];
    }
    hexagons.home = {0.0, 0.0, 285.0};
    const Scratch scratch;
    const std::string file = scratch.file("hexagons.toml", hexagons.toml());
    for (const char* method :
         {"newton", "newton-as-published", "mpr2", "mpr3", "mpr2-nr", "mpr3-nr", "fsi"}) {
        SCOPED_TRACE(method);
        const Outcome outcome =
            cli({"forward", "-", "--platform", file, "--method", method},
                csv(lengthColumns(), {hexagons.lengths({}), hexagons.lengths({5, 0, 3, 2, 0, 1})}));
        EXPECT_EQ(outcome.status, 1) << outcome.err;
        const Table table(outcome.out);
        ASSERT_EQ(table.rows.size(), 2U) << outcome.err;
        for (std::size_t row : {0U, 1U})
            EXPECT_EQ(table.field(row, "status"), "singular");
    }
}

TEST(Forward, APlatformTooCloseToSingularForAModelGetsRowsAndAWarning) {
    Machine inches = laboratory();
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            inches.base[i][k] /= 25.4;
            inches.platform[i][k] /= 25.4;
        }
    }
    const Scratch scratch;
    const std::string file = scratch.file("inches.toml", inches.toml());
    const std::string warning = "hexapose-cli: warning: " + file +
                                ": its geometry is too close to singular at home; likely cause: base_mm and "
                                "platform_mm are in inches\n";
    const std::string lengths =
        csv(lengthColumns(), {inches.lengths({}), inches.lengths({1, 0, 2, 0, 1, 0})});
    for (const char* method : {"newton", "mpr2", "mpr3-nr", "fsi"}) {
        SCOPED_TRACE(method);
        const Outcome outcome = cli({"forward", "-", "--platform", file, "--method", method}, lengths);
        EXPECT_EQ(Table(outcome.out).rows.size(), 2U);
        EXPECT_EQ(outcome.err, warning);
    }
    const Outcome inverse =
        cli({"inverse", "-", "--platform", file}, csv(poseColumns(), {{}, {1, 0, 2, 0, 1, 0}}));
    EXPECT_EQ(Table(inverse.out).rows.size(), 2U);
    EXPECT_EQ(inverse.err, warning);
}

TEST(Forward, ForeignLocalesChangeNoNumber) {
    const Outcome plain = cli({"forward", "-"}, kPublished);
    const Outcome german = cli({"forward", "-", "--tolerance-mm", "0.001"}, kPublished,
                               {{"LANG", "de_DE.UTF-8"}, {"LC_ALL", "de_DE.UTF-8"}, {"LC_NUMERIC", "de_DE"}});
    EXPECT_EQ(german.status, 0) << german.err;
    EXPECT_NEAR(Table(german.out).number(0, "z_mm"), Table(plain.out).number(0, "z_mm"), 1e-3);
    const Outcome same =
        cli({"forward", "-"}, kPublished, {{"LANG", "de_DE.UTF-8"}, {"LC_ALL", "de_DE"}, {"LANGUAGE", "de"}});
    EXPECT_EQ(same.out, plain.out);
}

/// From a pose that is known, to one 3 mm and 2 deg further: the regression leads to a third one, far away,
/// of the same lengths.
TEST(Forward, MprNewtonFollowsThePathFromAKnownPoseWhereItIsNotSure) {
    const std::string known = "1.43,2.61,-20.34,-69.41,-66.87,-68.03";
    const Six truth{0.52, 3.64, -18.35, -70.33, -65.49, -66.64};
    const std::string lengths = csv(lengthColumns(), {laboratory().lengths(truth)});
    const Outcome outcome = cli({"forward", "-", "--start=" + known, "--details"}, lengths);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const Table table(outcome.out);
    ASSERT_EQ(table.rows.size(), 1U);
    for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(table.number(0, poseColumns()[k]), truth[k], 1e-6);
    EXPECT_EQ(table.field(0, "status"), "converged");
    EXPECT_EQ(table.field(0, "fallback"), "followed");
    EXPECT_EQ(table.field(0, "fallback_step"), "1000");
    const Table fromHome(
        cli({"forward", "-", "--details"}, lengths + kPublished.substr(kPublished.find('\n') + 1)).out);
    EXPECT_GT(std::abs(fromHome.number(0, "x_mm") - truth[0]), 1.0) << "then there is nothing to show here";
    EXPECT_EQ(fromHome.field(1, "fallback"), "");
    EXPECT_EQ(fromHome.field(1, "fallback_step"), "");
}

TEST(Forward, BadStartsAreRefused) {
    for (const char* start : {"here", "1,2,3", "1,2,3,4,5,6,7", "1,2,3,4,5,nan", "1,2,3,4,5,"}) {
        const Outcome outcome = cli({"forward", "-", std::string("--start=") + start}, kPublished);
        EXPECT_EQ(outcome.status, 2) << start;
        EXPECT_NE(outcome.err.find("--start"), std::string::npos) << outcome.err;
    }
}

struct RoundTripCase {
    const char* name;
    Machine machine;
    double rangeMm;
    double rangeDeg;
    double scale;
    friend void PrintTo(const RoundTripCase& row, std::ostream* out) { *out << row.name; }
};

class RoundTrip : public testing::TestWithParam<RoundTripCase> {};

TEST_P(RoundTrip, ComesBackToThePose) {
    const auto& [name, machine, rangeMm, rangeDeg, scale] = GetParam();
    const Scratch scratch;
    const std::string platform = scratch.file("machine.toml", machine.toml());
    const std::vector<Six> poses = machine.poses(40, rangeMm, rangeDeg, 17);
    const Outcome inverse =
        cli({"inverse", scratch.file("poses.csv", csv(poseColumns(), poses)), "--platform", platform});
    EXPECT_EQ(inverse.status, 0) << inverse.err << inverse.out;
    const Table lengths(inverse.out);
    ASSERT_EQ(lengths.rows.size(), poses.size());
    const double exact = 1e-9 * scale; // mm
    for (std::size_t row = 0; row < poses.size(); ++row) {
        const Six expected = machine.lengths(poses[row]);
        for (std::size_t i = 0; i < 6; ++i)
            ASSERT_NEAR(lengths.number(row, lengthColumns()[i]), expected[i], exact);
    }
    for (const char* method : {"newton", "mpr3-nr"}) {
        for (const char* start : {"home", "previous"}) {
            SCOPED_TRACE(std::string(method) + " from " + start);
            const Outcome forward = cli(
                {"forward", "--method", method, "--start", start, "--platform", platform, "-"}, inverse.out);
            EXPECT_EQ(forward.status, 0) << forward.err << forward.out;
            const Table table(forward.out);
            ASSERT_EQ(table.rows.size(), poses.size());
            for (std::size_t row = 0; row < poses.size(); ++row)
                for (std::size_t k = 0; k < 6; ++k)
                    ASSERT_NEAR(table.number(row, poseColumns()[k]), poses[row][k],
                                k < 3 ? 1e-6 * scale : 1e-6)
                        << poseColumns()[k] << " in row " << row;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Machines, RoundTrip,
    testing::Values(RoundTripCase{"Laboratory", laboratory(), 20, 15, 1},
                    RoundTripCase{"Irregular", irregular(23), 25, 12, 1},
                    RoundTripCase{"Octahedral", octahedral(), 60, 15, 1},
                    RoundTripCase{"ThousandTimes", scaled(laboratory(), 1000), 20000, 15, 1000},
                    RoundTripCase{"Thousandth", scaled(laboratory(), 0.001), 0.02, 15, 0.001}),
    [](const auto& row) { return std::string(row.param.name); });

} // namespace
} // namespace hexapose::apptest
