// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/input_error.h"
#include "core/base/unit_text.h"
#include "core/base/utc_text.h"
#include "core/record/log_columns.h"
#include "core/record/log_reader.h"
#include "core/record/log_writer.h"
#include "tests/core/record/record_fixture.h"
#include "tests/support/events.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>
#include <string_view>

namespace hexapose {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Not every double in metres or radians has one in mm or degrees; m and rad, for values below 0.5.
constexpr double kLastBit = 1e-16;

TEST(Words, ReadBack) {
    for (int i = 0; i < 8; ++i) {
        const auto state = static_cast<RunState>(i);
        EXPECT_EQ(runStateFromWord(toWord(state)), state);
    }
    EXPECT_EQ(toWord(RunState::Unreferenced), "unreferenced");
    EXPECT_FALSE(runStateFromWord("Moving").has_value());
    for (std::size_t i = 0; i < eventCodeCount(); ++i) {
        const auto code = static_cast<EventCode>(i);
        EXPECT_EQ(eventCodeFromWord(toWord(code)), code);
    }
    EXPECT_FALSE(eventCodeFromWord("").has_value());
}

TEST(UnitText, IsPlainAndReadsBack) {
    EXPECT_EQ(mmText(0.3395), "339.5");
    EXPECT_EQ(degText(radiansFromDeg(5.0)), "5");
    EXPECT_EQ(mmText(std::nan("")), "");
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-2.0, 2.0);
    for (int i = 0; i < 10000; ++i) {
        const double value = uniform(random) * std::pow(10.0, i % 20 - 15);
        EXPECT_DOUBLE_EQ(metresFromMm(std::stod(mmText(value))), value);
        EXPECT_DOUBLE_EQ(radiansFromDeg(std::stod(degText(value))), value);
    }
}

TEST(UtcText, ReadsBack) {
    const auto time = fullSnapshot().wallTime;
    EXPECT_EQ(formatUtc(time), "2026-03-01T14:05:09.250Z");
    EXPECT_EQ(parseUtc("2026-03-01T14:05:09.250Z"), time);
    EXPECT_EQ(parseUtc("2026-03-01T14:05:09Z"), time - std::chrono::milliseconds(250));
    EXPECT_EQ(formatUtc({}), "1970-01-01T00:00:00.000Z");
    for (const char* bad : {"", "2026-03-01", "2026-13-01T14:05:09Z", "2026-03-01T14:05:09",
                            "2026-03-01T14:05:09.Z", "2026-03-01T14:05:09.2x0Z", "2026-03-01T24:05:09Z"})
        EXPECT_FALSE(parseUtc(bad).has_value()) << bad;
}

TEST(LogRow, HoldsEveryColumnOfTheContract) {
    EXPECT_EQ(
        logHeader(),
        "time_s,time_iso,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm,l1_set_mm,l2_set_mm,l3_set_mm,l4_set_mm,"
        "l5_set_mm,"
        "l6_set_mm,x_target_mm,y_target_mm,z_target_mm,alpha_target_deg,beta_target_deg,gamma_target_"
        "deg,x_mm,y_mm,"
        "z_mm,alpha_deg,beta_deg,gamma_deg,status,iterations,residual_mm,state,age_ms,dropped,x_path_mm,"
        "y_path_mm,z_path_mm,alpha_path_deg,beta_path_deg,gamma_path_deg,mode,speed_percent,q,controller_"
        "time_"
        "us,round_trip_ms,jitter_ms,l1_error_mm,l2_error_mm,l3_error_mm,l4_error_mm,l5_error_mm,l6_error_mm,"
        "event\n");
    Snapshot s = fullSnapshot(3);
    s.measuredPose = Pose{{0.012, -0.004, 0.04}, {radiansFromDeg(1), radiansFromDeg(-2.5), 0}};
    s.commandedLengths = LegLengths::Constant(0.3);
    s.targetPose = Pose{{0.001, 0.002, 0.003}, {0, 0, radiansFromDeg(5)}};
    s.mode = MotionMode::Workspace;
    s.speed = 0.5;
    s.determinantRatio = 0.75;
    s.controllerTime = std::chrono::microseconds(4294967295);
    s.roundTrip = std::chrono::microseconds(12345);
    s.jitter = std::chrono::microseconds(-250);
    s.events = {eventFrom("controller-refused say, \"no\"")};
    std::string row;
    appendLogRow(s, row);
    EXPECT_EQ(
        row,
        "0.030000,2026-03-01T14:05:09.280Z,339.5,336.5,336.6,329.2,345.1,334.5,300,300,300,300,300,300,12,-4,"
        "40,0,0,5,12,-4,40,1,-2.5,0,converged,3,1.25e-09,moving,1.5,3,1,2,3,0,0,5,workspace,50,0.7500,"
        "4294967295,12.345,-0.250,-39.5,-36.5,-36.6,-29.2,-45.1,-34.5,"
        "\"controller-refused say, \"\"no\"\"\"\n");
}

TEST(LogRow, IsEmptyWhereNothingIsKnown) {
    std::string row;
    appendLogRow(Snapshot{}, row);
    EXPECT_EQ(row, "0.000000,1970-01-01T00:00:00.000Z,,,,,,,,,,,,,,,,,,,,,,,,,,,,disconnected,,0,,,,,,,joint,"
                   "100,,,,,,,,,,,\n");
    Snapshot old = fullSnapshot();
    old.fresh = false;
    row.clear();
    appendLogRow(old, row);
    EXPECT_THAT(row, HasSubstr("Z,,,,,,,300.00000000000006,")) << "an old measurement is not written again";
    EXPECT_THAT(row, HasSubstr(",40,0,0,5,,,,,,,,,,moving,1.5,3,"));
}

TEST(LogRow, KnowsOfTheLinkAndTheLegsErrorsOnlyWithAMeasurement) {
    Snapshot s = fullSnapshot();
    s.controllerTime = std::chrono::microseconds(7);
    s.roundTrip = s.jitter = std::chrono::microseconds(1);
    s.measuredLengths = s.commandedLengths;
    std::string row;
    appendLogRow(s, row);
    EXPECT_THAT(row, testing::EndsWith(",7,0.001,0.001,0,0,0,0,0,0,\n"));
    s.fresh = false;
    row.clear();
    appendLogRow(s, row);
    EXPECT_THAT(row, testing::EndsWith(",,,,,,,,,,\n"));
}

TEST(LogRow, LeavesOutAResidualThatIsNoNumber) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        Snapshot s = fullSnapshot();
        s.status = SolveStatus::Singular;
        s.residual = bad;
        std::string row;
        appendLogRow(s, row);
        EXPECT_THAT(row, HasSubstr(",singular,3,,moving,")) << bad;
    }
}

class SessionLogTest : public testing::Test {
protected:
    const ScratchDirectory scratch;
};

TEST_F(SessionLogTest, ReadsBackWhatWasWritten) {
    const LogMetadata metadata = sampleMetadata();
    std::vector<Snapshot> written;
    {
        LogWriter writer(scratch / "run.csv", metadata);
        EXPECT_EQ(writer.file(), scratch / "run.csv");
        for (int i = 0; i < 1000; ++i) {
            Snapshot s = fullSnapshot(i);
            s.measuredLengths->array() += i * 1.0e-7 / 3.0;
            if (i == 500)
                s.events = {eventFrom("move-refused leg 3 above max_mm")};
            written.push_back(s);
            writer.append(s);
        }
        EXPECT_EQ(writer.rowCount(), 1000U);
        EXPECT_EQ(writer.lostCount(), 0U);
        EXPECT_FALSE(writer.failure().has_value());
    }
    const SessionLog log = readSessionLog(scratch / "run.csv");
    EXPECT_THAT(log.warnings, IsEmpty());
    ASSERT_EQ(log.rows.size(), written.size());
    for (std::size_t i = 0; i < written.size(); ++i) {
        EXPECT_EQ(log.rows[i].time, written[i].time);
        EXPECT_EQ(log.rows[i].wallTime, written[i].wallTime);
        EXPECT_LE((*log.rows[i].measuredLengths - *written[i].measuredLengths).cwiseAbs().maxCoeff(),
                  kLastBit);
        EXPECT_EQ(log.rows[i].commandedLengths, written[i].commandedLengths);
        EXPECT_EQ(log.rows[i].goalPose->toVector(), written[i].goalPose->toVector());
        EXPECT_TRUE(
            log.rows[i].measuredPose->toVector().isApprox(written[i].measuredPose->toVector(), 1e-15));
        EXPECT_EQ(log.rows[i].status, SolveStatus::Converged);
        EXPECT_EQ(log.rows[i].iterations, 3);
        EXPECT_DOUBLE_EQ(log.rows[i].residual, written[i].residual);
        EXPECT_EQ(log.rows[i].state, RunState::Moving);
        EXPECT_EQ(log.rows[i].age, written[i].age);
        EXPECT_TRUE(log.rows[i].fresh);
        EXPECT_EQ(log.rows[i].events.size(), i == 500 ? 1U : 0U);
    }
    ASSERT_TRUE(log.platform.has_value());
    EXPECT_EQ(log.platform->name, metadata.platform.name);
    EXPECT_EQ(log.platform->fingerprint(), metadata.platform.fingerprint());
    EXPECT_EQ(log.platform->legs[3].maxLength, metadata.platform.legs[3].maxLength);
    EXPECT_EQ(log.modelFingerprint, metadata.modelFingerprint);
    EXPECT_EQ(log.programVersion, metadata.programVersion);
    EXPECT_EQ(log.solver, metadata.solver);
    EXPECT_EQ(readLogMetadata(scratch / "run.toml").port, metadata.port);
}

TEST_F(SessionLogTest, ReadsALogOfAnotherTool) {
    const SessionLog log = readSessionLog(
        scratch.write("other.csv", "\xEF\xBB\xBF"
                                   "comment,l6_mm,l5_mm,l4_mm,l3_mm,l2_mm,l1_mm,time_s,x_mm,state\r\n"
                                   "\"a, b\",306,305,304,303,302,301,1.5,7,enabled\r\n"
                                   ",,,,,,,1.75,,moving\r\n"));
    EXPECT_THAT(log.warnings, IsEmpty());
    ASSERT_EQ(log.rows.size(), 2U);
    EXPECT_EQ((*log.rows[0].measuredLengths)[0], 0.301);
    EXPECT_EQ((*log.rows[0].measuredLengths)[5], 0.306);
    EXPECT_EQ(log.rows[0].time, std::chrono::milliseconds(1500));
    EXPECT_EQ(log.rows[0].state, RunState::Enabled);
    EXPECT_FALSE(log.rows[0].measuredPose.has_value()) << "a single coordinate is no pose";
    EXPECT_FALSE(log.rows[1].fresh);
    EXPECT_FALSE(log.rows[1].measuredLengths.has_value());
    EXPECT_FALSE(log.platform.has_value());
}

TEST_F(SessionLogTest, LeavesOutOnlyTheRowsThatCannotBeRead) {
    const std::string header = "time_s,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm,state,status\n";
    const SessionLog log =
        readSessionLog(scratch.write("bad.csv", header + "0,1,2,3,4,5,6,enabled,converged\n"
                                                         "0.1,1,2,nan,4,5,6,enabled,converged\n"
                                                         "0.2,1,2,,4,5,6,enabled,converged\n"
                                                         "inf,1,2,3,4,5,6,enabled,converged\n"
                                                         "0.4,1,2,3,4,5,6,dreaming,converged\n"
                                                         "0.5,1,2,3,4,5,6,enabled,perhaps\n"
                                                         "0.6,1,2,3\n"
                                                         "1e300,1,2,3,4,5,6,enabled,converged\n"
                                                         "0.8,1,2,3,4,5,6,enabled,singular\n"
                                                         "0.9,1,2,3,4"));
    ASSERT_EQ(log.rows.size(), 2U);
    EXPECT_EQ(log.rows[1].status, SolveStatus::Singular);
    ASSERT_EQ(log.warnings.size(), 8U);
    EXPECT_THAT(log.warnings[0], HasSubstr("bad.csv:3: row left out: l3_mm \"nan\" is not a finite number"));
    EXPECT_THAT(log.warnings[7], HasSubstr("bad.csv:11: half-written"));

    // Whole in all that is needed, and yet a field short or long: which of them is missing nobody knows.
    const SessionLog odd =
        readSessionLog(scratch.write("odd.csv", header + "0,1,2,3,4,5,6,enabled\n"
                                                         "0.1,1,2,3,4,5,6,enabled,converged,7\n"
                                                         "0.2,1,2,3,4,5,6,enabled,converged\n"));
    EXPECT_THAT(odd.warnings,
                ElementsAre(HasSubstr("odd.csv:2: row left out: 8 fields, but the header has 9"),
                            HasSubstr("odd.csv:3: row left out: 10 fields, but the header has 9")));
    ASSERT_EQ(odd.rows.size(), 1U);
    EXPECT_EQ(odd.rows[0].time, std::chrono::milliseconds(200));

    std::string many = header;
    for (int i = 0; i < 250; ++i)
        many += "x,1,2,3,4,5,6,enabled,converged\n";
    const SessionLog rubbish = readSessionLog(scratch.write("many.csv", many));
    EXPECT_EQ(rubbish.warnings.size(), 101U);
    EXPECT_THAT(rubbish.warnings.back(), HasSubstr("150 more rows"));
}

TEST_F(SessionLogTest, NeverAssumesAPlatformWhenTheFileBesideItIsDamaged) {
    const auto log = scratch.write("run.csv", "time_s,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n0,1,2,3,4,5,6\n");
    scratch.write("run.toml", "format = 1\n[platform\n");
    EXPECT_THROW(readSessionLog(log), InputError);
    scratch.write("run.toml", "[platform]\nname = \"half\"\n");
    EXPECT_THROW(readSessionLog(log), InputError);
    scratch.write("run.toml", "format = 1\n");
    EXPECT_THAT(readSessionLog(log).warnings, ElementsAre(HasSubstr("run.toml: holds no [platform]")));
    EXPECT_THROW(readSessionLog(scratch.write("x.csv", "time_s,l1_mm\n")), InputError);
}

TEST_F(SessionLogTest, RefusesAPlatformThatIsNotTheRecordedOne) {
    const auto log = scratch.write("run.csv", "time_s,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n0,1,2,3,4,5,6\n");
    const LogMetadata recorded = sampleMetadata();
    LogMetadata another = recorded;
    another.platform.legs[3].p_OA_B.x() += 1e-6; // m
    const std::string whole = formatLogMetadata(recorded, {});
    const std::string edited = formatLogMetadata(another, {});
    constexpr std::string_view kPlatform = "\n[platform]\n";
    scratch.write("run.toml", whole.substr(0, whole.find(kPlatform)) + edited.substr(edited.find(kPlatform)));
    try {
        readSessionLog(log);
        ADD_FAILURE() << "a joint that was moved afterwards is believed";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("not the platform_fingerprint " + recorded.platform.fingerprint()));
    }
    scratch.write("run.toml", whole);
    EXPECT_EQ(readSessionLog(log).platform->fingerprint(), recorded.platform.fingerprint());
}

} // namespace
} // namespace hexapose
