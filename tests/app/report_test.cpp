// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Reports of logs as another program may have written them: whole, cut in the middle, alone, wrong.
#include "tests/app/bad_call.h"
#include "tests/app/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace hexapose::apptest {
namespace {

using testing::HasSubstr;

const std::vector<Six> kTargets{{12, -4, 40, 0, 0, 5}, {-6, 5, 20, 3, -2, -4}, {0, 8, -10, -5, 1, 2}};

std::string logRow(const Machine& machine, double seconds, const Six& target, double part,
                   const char* state) {
    Six pose = target;
    for (double& value : pose)
        value *= part;
    std::string row = shortest(seconds);
    for (const double length : machine.lengths(pose))
        row += "," + shortest(std::round(length * 10.0) / 10.0);
    for (const double value : target)
        row += "," + shortest(value);
    return row + "," + state + "\n";
}

/// The columns a report needs, at 20 Hz: a move, settling, and a second and more of standing, for each
/// target.
std::string writeLog(const Machine& machine) {
    std::string text = "time_s,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm,x_target_mm,y_target_mm,z_target_mm,"
                       "alpha_target_deg,beta_target_deg,gamma_target_deg,state\n";
    int tick = 0;
    const auto add = [&](const Six& target, double part, const char* state) {
        text += logRow(machine, 0.05 * tick++, target, part, state);
    };
    for (const Six& target : kTargets) {
        for (int i = 1; i <= 20; ++i)
            add(target, 0.05 * i, "moving");
        for (int i = 0; i < 6; ++i)
            add(target, 1.0, "settling");
        for (int i = 0; i < 24; ++i)
            add(target, 1.0, "enabled");
    }
    return text;
}

/// Solved poses agree with the targets as far as lengths with one decimal can tell.
void expectErrors(const std::string& file, std::size_t count) {
    const Table errors(readText(file));
    ASSERT_EQ(errors.rows.size(), count);
    for (std::size_t row = 0; row < count; ++row)
        for (std::size_t k = 0; k < 6; ++k) {
            const std::string name = poseColumns()[k];
            const std::string unit = name.substr(name.find('_'));
            const std::string coordinate = name.substr(0, name.find('_'));
            const double error = errors.number(row, coordinate + "_error" + unit);
            EXPECT_NEAR(errors.number(row, name), kTargets[row][k] + error, 1e-9);
            EXPECT_LE(std::abs(error), errors.number(row, coordinate + "_bound" + unit) * 1.01) << name;
        }
}

TEST(Report, OfAWholeLogACutLogAndOneWithoutItsPlatform) {
    const Scratch scratch;
    const Machine lab = laboratory();
    const std::string text = writeLog(lab);
    const auto report = [&](const std::string& log, const std::string& out) {
        return cli({"report", log, "--platform", "laboratory", "--out", scratch.path(out)});
    };
    const Outcome whole = report(scratch.file("whole.csv", text), "whole");
    EXPECT_EQ(whole.status, 0) << whole.err;
    EXPECT_EQ(whole.err, "");
    // Without a word of the platform it is taken for the laboratory's, and that is said.
    const Outcome assumed = cli({"report", scratch.path("whole.csv"), "--out", scratch.path("assumed")});
    EXPECT_EQ(assumed.status, 0) << assumed.err;
    EXPECT_EQ(notOneLineWith(assumed.err, {scratch.path("whole.csv"), "Laboratory platform"}), "");
    EXPECT_EQ(readText(scratch.path("assumed/errors.csv")), readText(scratch.path("whole/errors.csv")));
    expectErrors(scratch.path("whole/errors.csv"), 3);
    for (const char* name : {"report.pdf", "errors.csv", "errors.png", "errors.svg"}) {
        EXPECT_THAT(whole.out, HasSubstr(scratch.path(std::string("whole/") + name) + "\n"));
        EXPECT_FALSE(readText(scratch.path(std::string("whole/") + name)).empty());
    }

    // Cut in the last line, in the middle of a number: said, and the rest counts.
    const Outcome cut = report(scratch.file("cut.csv", text.substr(0, text.size() - 30)), "cut");
    EXPECT_EQ(cut.status, 0) << cut.err;
    EXPECT_EQ(notOneLineWith(cut.err, {scratch.path("cut.csv"), "half-written last line"}), "");
    expectErrors(scratch.path("cut/errors.csv"), 3);

    // Cut within the third second of standing: the two before it are whole.
    const std::size_t third = text.rfind("settling");
    const Outcome two = report(scratch.file("two.csv", text.substr(0, third)), "two");
    EXPECT_EQ(two.status, 0) << two.err;
    expectErrors(scratch.path("two/errors.csv"), 2);

    // A row that cannot be read is left out and said.
    std::string spoilt = text;
    spoilt.replace(spoilt.find("enabled"), 7, "upright");
    const Outcome one = report(scratch.file("spoilt.csv", spoilt), "spoilt");
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_EQ(notOneLineWith(one.err, {scratch.path("spoilt.csv") + ":28:", "upright"}), "");
    expectErrors(scratch.path("spoilt/errors.csv"), 3);

    // Another machine: told on the command line, or in the file beside the log.
    const Machine other = irregular(31);
    const std::string log = scratch.file("other.csv", writeLog(other));
    const std::string platform = scratch.file("machine.toml", other.toml());
    const Outcome told = cli({"report", log, "--platform", platform, "--out", scratch.path("told")});
    EXPECT_EQ(told.status, 0) << told.err;
    expectErrors(scratch.path("told/errors.csv"), 3);

    // From standard input, in a directory that has to be made.
    const Outcome piped = cli({"report", "-", "--out", scratch.path("a/b/c"), "--method", "newton"}, text);
    EXPECT_EQ(piped.status, 0) << piped.err;
    expectErrors(scratch.path("a/b/c/errors.csv"), 3);
}

TEST(Report, BadLogsAreRefused) {
    const Scratch scratch;
    const std::string text = writeLog(laboratory());
    const std::string header = text.substr(0, text.find('\n') + 1);
    scratch.file("good.csv", text);
    scratch.file("empty.csv", "");
    scratch.file("header.csv", header);
    scratch.file("standing.csv", header + logRow(laboratory(), 0.0, kTargets[0], 1.0, "enabled"));
    scratch.file("timeless.csv", "when" + text.substr(6));
    scratch.file("legless.csv", "time_s,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm\n0,1,2,3,4,5\n");
    scratch.file("quote.csv", header + "\"0,1\n2,3\n");
    scratch.file("beside.csv", text);
    scratch.file("beside.toml", "format = 1\nprogram = [\n");
    scratch.file("crooked.csv", text);
    scratch.file("crooked.toml", "format = 1\n[platform]\nformat = 1\nname = \"x\"\n");
    scratch.file("plain", "");
    const std::string printed = "format = 1\nplatform_fingerprint = \"0123456789abcdef\"\n";
    const auto under = [](std::string toml) {
        for (std::size_t at = 0; (at = toml.find("[[leg]]", at)) != std::string::npos; at += 9)
            toml.replace(at, 7, "[[platform.leg]]");
        toml.replace(toml.find("[home]"), 6, "[platform.home]");
        return "[platform]\n" + toml;
    };
    for (const char* name : {"foreign.csv", "printed.csv", "recorded.csv"})
        scratch.file(name, text);
    scratch.file("foreign.toml", printed + under(laboratory().toml()));
    scratch.file("printed.toml", printed);
    scratch.file("recorded.toml", "format = 1\n" + under(laboratory().toml()));
    scratch.file("other.toml", octahedral().toml());
    const std::string out = " --out @out";
    expectRefused(
        HEXAPOSE_CLI, scratch,
        {
            {"report" + out, {"missing"}},
            {"report @good.csv", {"--out"}},
            {"report @good.csv --out", {"out"}},
            {"report @good.csv --out @plain", {"@plain"}},
            {"report @good.csv --out @plain/out", {"@plain"}},
            {"report @good.csv --method magic" + out, {"--method", "magic"}},
            {"report @good.csv --resolution-mm -1" + out, {"--resolution-mm", "-1"}},
            {"report @missing.csv" + out, {"@missing.csv"}},
            {"report @empty.csv" + out, {"@empty.csv", "empty"}},
            {"report @header.csv" + out, {"@header.csv", "no settled attitude"}},
            {"report @standing.csv" + out, {"@standing.csv", "no settled attitude"}},
            {"report @timeless.csv" + out, {"@timeless.csv:1:", "time_s"}},
            {"report @legless.csv" + out, {"@legless.csv:1:", "l6_mm"}},
            {"report @quote.csv" + out, {"@quote.csv:2:", "quote"}},
            {"report @beside.csv" + out, {"@beside.toml:"}},
            {"report @crooked.csv" + out, {"@crooked.toml", "home"}},
            {"report @foreign.csv" + out, {"@foreign.toml", "platform_fingerprint 0123456789abcdef"}},
            {"report @printed.csv --platform @other.toml" + out, {"--platform", "0123456789abcdef"}},
            {"report @printed.csv" + out, {"--platform", "0123456789abcdef"}},
            {"report @recorded.csv --platform @other.toml" + out, {"--platform", "fingerprint"}},
        });
}

} // namespace
} // namespace hexapose::apptest
