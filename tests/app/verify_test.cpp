// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A recorded run solved again, and compared with another.
#include "tests/app/bad_call.h"
#include "tests/app/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace hexapose::apptest {
namespace {

using testing::HasSubstr;

/// A log of a sine of `machine`, its clock ahead by `shift`; in row 20 z is written 0.5 mm too high.
std::string sineLog(const Machine& machine, double shift, bool wrong) {
    std::string text =
        "time_s,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm,x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg,event\n";
    for (int i = 0; i < 200; ++i) {
        const double t = 0.02 * i;
        const Six pose{10 * std::sin(t), 5 * std::cos(2 * t), 8 * std::sin(3 * t),
                       2 * std::sin(t),  std::cos(t),         3 * std::sin(2 * t)};
        text += shortest(t + shift);
        for (const double length : machine.lengths(pose))
            text += "," + shortest(length);
        for (std::size_t k = 0; k < 6; ++k)
            text += "," + shortest(pose[k] + (wrong && i == 20 && k == 2 ? 0.5 : 0.0));
        text += i == 30 ? ",begin\n" : ",\n";
    }
    return text;
}

TEST(Verify, ListsWhatTheLengthsDoNotGive) {
    const Scratch scratch;
    const std::string good = scratch.file("good.csv", sineLog(laboratory(), 0.0, false));
    const std::string wrong = scratch.file("wrong.csv", sineLog(laboratory(), 0.0, true));
    for (const char* method : {"newton", "mpr3-nr"}) {
        SCOPED_TRACE(method);
        const Outcome same = cli({"verify", good, "--method", method});
        EXPECT_EQ(same.status, 0) << same.err << same.out;
        EXPECT_EQ(same.out, "line,column,recorded,solved\n");
        const Outcome other = cli({"verify", wrong, "--method", method});
        EXPECT_EQ(other.status, 1);
        const Table table(other.out);
        ASSERT_EQ(table.rows.size(), 1U);
        EXPECT_EQ(table.field(0, "line"), "22");
        EXPECT_EQ(table.field(0, "column"), "z_mm");
        EXPECT_NEAR(table.number(0, "recorded") - table.number(0, "solved"), 0.5, 1e-6);
    }
    EXPECT_EQ(cli({"verify", wrong, "--tolerance-mm", "0.6"}).status, 0);
}

TEST(Verify, TakesThePlatformBesideTheLog) {
    const Scratch scratch;
    Machine other = laboratory();
    for (auto& joint : other.platform)
        joint[0] *= 1.1;
    const std::string platform = scratch.file("other.toml", other.toml());
    const std::string log = scratch.file("run.csv", sineLog(other, 0.0, false));
    EXPECT_EQ(cli({"verify", log, "--method", "newton"}).status, 1) << "of the laboratory they are not";
    EXPECT_EQ(cli({"verify", log, "--method", "newton", "--platform", platform}).status, 0);
    scratch.file("run.toml", "[platform]\n" + other.toml());
    const Outcome beside = cli({"verify", log, "--method", "newton"});
    EXPECT_THAT(beside.err, HasSubstr("run.toml")) << "no metadata of ours: refused, never passed over";
    EXPECT_EQ(beside.status, 2);
}

TEST(Verify, RefusesFilesWithoutLengthsOrPose) {
    const Scratch scratch;
    const Outcome none = cli({"verify", scratch.file("a.csv", "time_s,a\n0,1\n")});
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(none.err, HasSubstr("a.csv: has no six columns of lengths"));
    const Outcome pose = cli({"verify", scratch.file("b.csv", "l1,l2,l3,l4,l5,l6\n1,2,3,4,5,6\n")});
    EXPECT_THAT(pose.err, HasSubstr("b.csv: has no recorded pose"));
}

TEST(Compare, FindsTheShiftOrTakesOne) {
    const Scratch scratch;
    const std::string a = scratch.file("a.csv", sineLog(laboratory(), 0.0, false));
    const std::string b = scratch.file("b.csv", sineLog(laboratory(), 7.5, true));
    const Outcome found = cli({"compare", a, b});
    EXPECT_EQ(found.status, 0) << found.err;
    const Table table(found.out);
    ASSERT_EQ(table.rows.size(), 12U);
    EXPECT_NEAR(table.number(0, "shift_s"), 7.5, 1e-6);
    EXPECT_EQ(table.field(8, "column"), "z_mm");
    EXPECT_NEAR(table.number(8, "largest"), 0.5, 1e-4);
    EXPECT_NEAR(table.number(8, "largest_at_s"), 0.4, 1e-9);
    EXPECT_NEAR(Table(cli({"compare", a, b, "--align", "begin"}).out).number(0, "shift_s"), 7.5, 1e-9);
    const Table given(cli({"compare", a, b, "--shift", "7.52"}).out);
    EXPECT_EQ(given.number(0, "shift_s"), 7.52);
    EXPECT_GT(given.number(0, "rms"), 0.01);
    EXPECT_THAT(cli({"compare", a, b, "--shift", "1", "--align", "x"}).err,
                HasSubstr("--align: cannot be given beside"));
    EXPECT_THAT(cli({"compare", a, b, "--align", "nothing"}).err, HasSubstr("--align: no event of"));
    EXPECT_EQ(cli({"compare", a, scratch.file("c.csv", "q,r\n1,2\n")}).status, 2);
}

} // namespace
} // namespace hexapose::apptest
