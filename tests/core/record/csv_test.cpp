// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/csv_table.h"
#include "core/base/input_error.h"
#include "core/record/pose_list.h"
#include "tests/core/record/record_fixture.h"

#include <gmock/gmock.h>

namespace hexapose {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CsvTable parse(const std::string& text) {
    std::istringstream in(text);
    return readCsv(in, "t.csv");
}

template <typename Action>
std::string messageOf(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Csv, ReadsQuotesByteOrderMarkAndEveryLineEnd) {
    const CsvTable table =
        parse("\xEF\xBB\xBF a , b\t,\"c\"\r\n1,\"two, \"\"2\"\"\nmore\",3\r\n\r\n   \n4,,\n5,6,7\r8,9,10");
    EXPECT_THAT(table.header, ElementsAre("a", "b", "c"));
    ASSERT_EQ(table.rows.size(), 4U);
    EXPECT_THAT(table.rows[0].fields, ElementsAre("1", "two, \"2\"\nmore", "3"));
    EXPECT_THAT(table.rows[1].fields, ElementsAre("4", "", ""));
    EXPECT_THAT(table.rows[2].fields, ElementsAre("5", "6", "7"));
    EXPECT_THAT(table.rows[3].fields, ElementsAre("8", "9", "10"));
    EXPECT_EQ(table.rows[0].line, 2);
    EXPECT_EQ(table.rows[1].line, 6) << "a line end inside a quote and blank lines count";
    EXPECT_THAT(table.warnings, IsEmpty());
    EXPECT_EQ(table.requireColumn("c"), 2U);
    EXPECT_FALSE(table.findColumn("d").has_value());
    EXPECT_EQ(CsvTable::field(table.rows[0], 7), "");
}

TEST(Csv, LeavesOutOnlyAHalfWrittenLastLine) {
    for (const std::string last : {"4,5", "4,5,\"torn", "\"4"}) {
        const CsvTable table = parse("a,b,c\n1,2\n1,2,3,4\n" + last);
        ASSERT_EQ(table.rows.size(), 2U) << "uneven rows elsewhere are the caller's to judge";
        EXPECT_THAT(table.warnings, ElementsAre("t.csv:4: half-written last line left out")) << last;
        ASSERT_TRUE(table.halfWritten.has_value());
        EXPECT_EQ(table.halfWritten->line, 4);
    }
    EXPECT_EQ(parse("a,b\n1,2\n3\n").rows.size(), 2U) << "a short line with its line end is a row";
    EXPECT_THAT(parse("a,b").rows, IsEmpty());
}

TEST(Csv, SaysWhatCannotBeRead) {
    EXPECT_EQ(messageOf([] { parse(""); }), "t.csv: is empty, a header row was expected");
    EXPECT_EQ(messageOf([] { parse("\n \n"); }), "t.csv: is empty, a header row was expected");
    EXPECT_EQ(messageOf([] { parse("a,b\n1,2\n3,\"open\n5,6\n"); }),
              "t.csv:3: a quote is opened and never closed");
    EXPECT_THAT(messageOf([] {
                    parse("\xFF\xFE"
                          "a\n");
                }),
                HasSubstr("not UTF-8"));
    EXPECT_EQ(messageOf([] { parse("a,b\n").requireColumn("l3_mm"); }), "t.csv:1: column l3_mm is missing");
    EXPECT_THAT(messageOf([] { parse("a;b\n").requireColumn("a"); }), HasSubstr("separated by commas"));
    EXPECT_EQ(messageOf([] { parse("a,a\n").requireColumn("a"); }), "t.csv:1: column a appears twice");
    const ScratchDirectory scratch;
    EXPECT_THAT(messageOf([&] { readCsv(scratch / "absent.csv"); }),
                HasSubstr("absent.csv: cannot be read: No such"));
    EXPECT_THAT(messageOf([&] { readCsv(scratch / ""); }), HasSubstr("is a directory"));
}

TEST(Csv, FieldsSurviveQuoting) {
    for (const std::string field :
         {"plain", "", "with, comma", "a \"quote\"", "two\nlines", " blanks ", "\r"}) {
        const CsvTable table = parse("a,b\n" + csvField(field) + ",x\n");
        ASSERT_EQ(table.rows.size(), 1U);
        EXPECT_EQ(table.rows[0].fields[0], field);
    }
    EXPECT_EQ(csvField("plain"), "plain");
}

TEST(Csv, ReadsRowsLongerThanItsBuffer) {
    const std::string large(300000, 'x');
    const CsvTable table = parse("a,b\n" + large + ",\"" + large + "\"\r\n1,2\r\n");
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.rows[0].fields[0], large);
    EXPECT_EQ(table.rows[0].fields[1], large);
}

constexpr const char* kPoseHeader = "name,gamma_deg,x_mm,y_mm,z_mm,alpha_deg,beta_deg\n";

TEST(PoseList, ReadsColumnsByName) {
    const ScratchDirectory scratch;
    const auto poses =
        readPoseList(scratch.write("p.csv", std::string(kPoseHeader) + "a,90,12,-4, 40 ,0,-0.5\n"));
    ASSERT_EQ(poses.size(), 1U);
    EXPECT_EQ(poses[0].offset, Eigen::Vector3d(0.012, -0.004, 0.04));
    EXPECT_EQ(poses[0].angles.gamma, radiansFromDeg(90));
    EXPECT_EQ(poses[0].angles.beta, radiansFromDeg(-0.5));
}

TEST(PoseList, RefusesWhatIsNotAListOfPlaces) {
    const ScratchDirectory scratch;
    const auto refusal = [&](const std::string& text) {
        return messageOf([&] { readPoseList(scratch.write("p.csv", text)); });
    };
    const std::string header = kPoseHeader;
    EXPECT_THAT(refusal("x_mm,y_mm\n1,2\n"), HasSubstr("p.csv:1: column z_mm is missing"));
    EXPECT_THAT(refusal(header), HasSubstr("p.csv: holds no attitudes"));
    EXPECT_THAT(refusal(header + "a,0,0,0,0,0,0\nb,0,nan,0,0,0,0\n"),
                HasSubstr("p.csv:3: x_mm \"nan\" is not a finite"));
    EXPECT_THAT(refusal(header + "a,0,,0,0,0,0\n"), HasSubstr("p.csv:2: x_mm \"\" is not"));
    EXPECT_THAT(refusal(header + "a,0,1e999,0,0,0,0\n"), HasSubstr("p.csv:2: x_mm"));
    EXPECT_THAT(refusal(header + "a,0,1,5,0,0,0,0\n"), HasSubstr("p.csv:2: 8 fields, but the header has 7"));
    EXPECT_THAT(refusal(header + "a,0,1,2,3,4,5\nb,0,1"), HasSubstr("p.csv:3: the last line is incomplete"));
}

} // namespace
} // namespace hexapose
