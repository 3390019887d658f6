// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/report/error_report.h"

#include "core/base/csv_table.h"
#include "core/base/input_error.h"
#include "core/base/units.h"
#include "core/kinematics/inverse_kinematics.h"
#include "tests/core/report/report_fixture.h"

#include <numbers>
#include <sstream>

namespace hexapose {
namespace {

constexpr double kResolution = 1e-4; // m
/// The prediction is of first order; the errors are a thousandth of the pose.
constexpr double kSecondOrder = 1.01;
constexpr double kSolved = 1e-8; // m, rad: far below a resolution, far above rounding

TEST(ErrorReport, TableFiveComesOut) {
    const PlatformGeometry geometry = laboratory();
    SettledSample sample;
    sample.target = Pose{{0.012, -0.004, 0.04}, {0.0, 0.0, radiansFromDeg(5.0)}};
    sample.meanLengths << 0.3395, 0.3365, 0.3366, 0.3292, 0.3451, 0.3345;
    const ErrorReport report = makeErrorReport(geometry, NewtonRaphson(geometry, {}), {sample});
    EXPECT_EQ(report.platformName, "Laboratory platform");
    EXPECT_EQ(report.solver, "newton");
    ASSERT_EQ(report.rows.size(), 1U);
    PoseVector published;
    published << 0.01199 - 0.012, -0.00404 + 0.004, 0.03978 - 0.04, -1.686e-4, 5.838e-5,
        0.08689 - radiansFromDeg(5.0);
    constexpr double kPrintedDigits = 5.1e-6;
    EXPECT_LE((report.rows[0].error - published).cwiseAbs().maxCoeff(), kPrintedDigits)
        << report.rows[0].error;
}

TEST(ErrorReport, RoundingNeverExceedsThePredictedBound) {
    const PlatformGeometry geometry = laboratory();
    const auto samples = roundedSamples(geometry, 200, kResolution);
    const ErrorReport report = makeErrorReport(geometry, NewtonRaphson(geometry, {}), samples, kResolution);
    ASSERT_EQ(report.rows.size(), 200U);
    EXPECT_EQ(report.failed, 0);
    PoseVector scaled = PoseVector::Zero();
    for (const ErrorRow& row : report.rows) {
        EXPECT_TRUE((row.error.cwiseAbs().array() <= kSecondOrder * row.predictedBound.array()).all())
            << row.number;
        scaled += row.error.cwiseQuotient(row.predictedSigma).cwiseAbs2();
    }
    // 200 squares of unit variance scatter by a tenth about 1; four times that.
    constexpr double kScatter = 0.4;
    for (const double variance : scaled / 200.0)
        EXPECT_NEAR(variance, 1.0, kScatter) << "the predicted standard deviation is that of the errors";
    EXPECT_TRUE((largestPredictedBound(report).array() >= report.statistics.maximum.array()).all());
}

TEST(ErrorReport, ThePredictedBoundIsReached) {
    const PlatformGeometry geometry = laboratory();
    const Pose target{{0.005, 0.002, -0.003}, {0.05, -0.04, 0.1}};
    const NewtonRaphson solver(geometry, {});
    PoseVector reached = PoseVector::Zero();
    for (unsigned corner = 0; corner < 64; ++corner) {
        SettledSample sample = sampleAt(geometry, target);
        for (int leg = 0; leg < kLegCount; ++leg)
            sample.meanLengths[leg] += (corner >> leg & 1U) != 0 ? kResolution / 2 : -kResolution / 2;
        const ErrorRow row = makeErrorReport(geometry, solver, {sample}, kResolution).rows[0];
        reached = reached.cwiseMax(row.error.cwiseAbs().cwiseQuotient(row.predictedBound));
    }
    constexpr double kFirstOrder = 0.01;
    for (const double part : reached)
        EXPECT_NEAR(part, 1.0, kFirstOrder);
}

TEST(ErrorReport, StatisticsLeaveOutWhatHasNoSolution) {
    const PlatformGeometry geometry = laboratory();
    const NewtonRaphson solver(geometry, {});
    std::vector<SettledSample> samples;
    for (const double offset : {3e-3, -1e-3}) {
        samples.push_back(sampleAt(geometry, Pose{{offset, 0, 0}, {0, 0, offset}}));
        samples.back().target = Pose{};
    }
    samples.push_back(sampleAt(geometry, Pose{}));
    samples.back().meanLengths[2] = std::nan("");
    const ErrorReport report = makeErrorReport(geometry, solver, samples);
    EXPECT_EQ(report.failed, 1);
    EXPECT_EQ(report.rows.size(), 3U);
    EXPECT_EQ(report.rows[2].number, 3);
    EXPECT_TRUE(std::isnan(report.rows[2].error[0])) << "no error is not a small one";
    for (const int k : {0, 5}) {
        EXPECT_NEAR(report.statistics.mean[k], 1e-3, kSolved);
        EXPECT_NEAR(report.statistics.rms[k], std::sqrt(5.0) * 1e-3, kSolved);
        EXPECT_NEAR(report.statistics.maximum[k], 3e-3, kSolved);
    }
    EXPECT_NEAR(report.statistics.maximum[1], 0.0, kSolved);

    for (const auto& none : {std::vector<SettledSample>{}, std::vector<SettledSample>{samples[2]}}) {
        const ErrorStatistics nothing = makeErrorReport(geometry, solver, none).statistics;
        EXPECT_TRUE(nothing.mean.array().isNaN().all() && nothing.rms.array().isNaN().all() &&
                    nothing.maximum.array().isNaN().all());
    }
}

TEST(ErrorReport, AnglesAreComparedTheShortWayRound) {
    const PlatformGeometry geometry = laboratory();
    SettledSample sample = sampleAt(geometry, Pose{Eigen::Vector3d::Zero(), {0.0, 0.0, 0.1}});
    sample.target.angles.gamma = 0.1 - 2.0 * std::numbers::pi;
    const ErrorRow row = makeErrorReport(geometry, NewtonRaphson(geometry, {}), {sample}).rows[0];
    EXPECT_NEAR(row.error[5], 0.0, kSolved);
}

TEST(ErrorReport, ASingularTargetHasNoBound) {
    PlatformGeometry flat = laboratory();
    flat.p_OP_home_B.z() = 0.0; // platform joints in the plane of the base joints: z does not change the legs
    const ErrorRow row = makeErrorReport(flat, NewtonRaphson(flat, {}), {sampleAt(flat, Pose{})}).rows[0];
    EXPECT_TRUE(std::isinf(row.predictedBound.maxCoeff()));
}

TEST(ErrorCsv, HoldsEverySampleUnderItsNames) {
    const PlatformGeometry geometry = laboratory();
    auto samples = roundedSamples(geometry, 4, kResolution);
    samples[1].meanLengths[0] = -1.0;
    const ErrorReport report = makeErrorReport(geometry, NewtonRaphson(geometry, {}), samples, kResolution);
    std::istringstream text(formatErrorCsv(report));
    const CsvTable table = readCsv(text, "errors.csv");
    ASSERT_EQ(table.rows.size(), 4U);
    const auto value = [&](std::size_t row, const char* column) {
        return std::string(CsvTable::field(table.rows[row], table.requireColumn(column)));
    };
    for (const CsvTable::Row& row : table.rows)
        EXPECT_EQ(row.fields.size(), table.header.size());
    const ErrorRow& third = report.rows[2];
    EXPECT_EQ(value(2, "number"), "3");
    EXPECT_DOUBLE_EQ(std::stod(value(2, "x_target_mm")), 1000 * third.sample.target.offset.x());
    EXPECT_DOUBLE_EQ(std::stod(value(2, "gamma_deg")), degFromRadians(third.solution.pose.angles.gamma));
    EXPECT_EQ(std::stod(value(2, "error_z_m")), third.error[2]);
    EXPECT_EQ(std::stod(value(2, "error_alpha_rad")), third.error[3]);
    EXPECT_DOUBLE_EQ(std::stod(value(2, "beta_error_deg")), degFromRadians(third.error[4]));
    EXPECT_DOUBLE_EQ(std::stod(value(2, "y_bound_mm")), 1000 * third.predictedBound[1]);
    EXPECT_DOUBLE_EQ(std::stod(value(2, "gamma_sigma_deg")), degFromRadians(third.predictedSigma[5]));
    EXPECT_EQ(value(2, "status"), "converged");
    EXPECT_DOUBLE_EQ(std::stod(value(2, "l6_mm")), 1000 * third.sample.meanLengths[5]);
    EXPECT_EQ(value(1, "status"), "invalid-input");
    EXPECT_EQ(value(1, "x_mm"), "");
    EXPECT_EQ(value(1, "error_x_m"), "");
    EXPECT_NE(value(1, "x_target_mm"), "");
}

TEST(RandomPoses, AreSeededReachableAndInRange) {
    const PlatformGeometry geometry = laboratory();
    const auto poses = randomPoses(geometry, 500, 0.06, 0.4, 11);
    const auto again = randomPoses(geometry, 500, 0.06, 0.4, 11);
    const auto other = randomPoses(geometry, 500, 0.06, 0.4, 12);
    ASSERT_EQ(poses.size(), 500U);
    PoseVector low = PoseVector::Zero();
    PoseVector high = PoseVector::Zero();
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const PoseVector v = poses[i].toVector();
        EXPECT_EQ(v, again[i].toVector());
        EXPECT_NE(v, other[i].toVector());
        const LegLengths lengths = legLengths(geometry, poses[i]);
        EXPECT_GE(lengths.minCoeff(), 0.25);
        EXPECT_LE(lengths.maxCoeff(), 0.35);
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    EXPECT_TRUE((high.head<3>().array() <= 0.06).all() && (low.tail<3>().array() >= -0.4).all());
    EXPECT_TRUE((high.head<2>().array() > 0.03).all() && (low.tail<3>().array() < -0.2).all())
        << "the box is used";
}

TEST(RandomPoses, RefusesWhatCannotBeDrawn) {
    PlatformGeometry stiff = laboratory();
    for (Leg& leg : stiff.legs)
        leg.maxLength = (leg.minLength = 0.1) + 1e-3;
    EXPECT_THROW(randomPoses(stiff, 1, 0.01, 0.1, 1), InputError);
    EXPECT_THROW(randomPoses(laboratory(), 1, -0.01, 0.1, 1), InputError);
    EXPECT_THROW(randomPoses(laboratory(), 1, 0.01, std::nan(""), 1), InputError);
    EXPECT_TRUE(randomPoses(laboratory(), 0, 0.01, 0.1, 1).empty());
}

TEST(DefaultPoses, FitMachinesOfShortStroke) {
    const auto usual = defaultPoses(laboratory(), 10, 1);
    EXPECT_EQ(usual.front().toVector(),
              randomPoses(laboratory(), 10, 0.01, radiansFromDeg(10.0), 1).front().toVector());
    PlatformGeometry tight = laboratory();
    const LegLengths home = tight.homeLengths();
    for (int i = 0; i < kLegCount; ++i) {
        Leg& leg = tight.legs[static_cast<std::size_t>(i)];
        leg.minLength = home[i] - 2e-4;
        leg.maxLength = home[i] + 2e-4;
    }
    EXPECT_THROW(randomPoses(tight, 10, 0.01, radiansFromDeg(10.0), 1), InputError);
    for (const Pose& pose : defaultPoses(tight, 10, 1))
        EXPECT_LE((legLengths(tight, pose) - home).cwiseAbs().maxCoeff(), 2e-4);
    for (Leg& leg : tight.legs)
        leg.maxLength = (leg.minLength = 0.1) + 1e-3;
    EXPECT_THROW(defaultPoses(tight, 1, 1), InputError);
}

} // namespace
} // namespace hexapose
