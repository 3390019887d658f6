// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The forms in which a log, or any CSV, comes.

#include "core/base/input_error.h"
#include "tests/core/table/table_files.h"

#include <gmock/gmock.h>

#include <cmath>

namespace hexapose {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kPlain = "time_s,l1_mm,event\n0,1.5,\n0.5,-2.25,start\n1,1e3,\n";

void expectPlain(const Table& table) {
    EXPECT_THAT(namesOf(table), ElementsAre("time_s", "l1_mm", "event"));
    EXPECT_THAT(numbersOf(table, "time_s"), ElementsAre(0.0, 0.5, 1.0));
    EXPECT_THAT(numbersOf(table, "l1_mm"), ElementsAre(1.5, -2.25, 1000.0));
    EXPECT_THAT(wordsOf(table, "event"), ElementsAre("", "start", ""));
    EXPECT_THAT(problemsOf(table), IsEmpty());
    EXPECT_EQ(table.columns()[1].info().label, "l1");
    EXPECT_EQ(table.columns()[1].info().unit, "mm");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

TEST(Reading, TakesEncodingsLineEndsAndCompression) {
    expectPlain(*tableOf(kPlain));
    expectPlain(*tableOf("\xEF\xBB\xBF" + kPlain));
    expectPlain(*tableOf(utf16(kPlain, false)));
    expectPlain(*tableOf(utf16(kPlain, true)));
    expectPlain(*tableOf(gzip(kPlain)));
    expectPlain(*tableOf(gzip("\xEF\xBB\xBF" + kPlain)));
    expectPlain(*tableOf(gzip(utf16(kPlain, false)), "no_gz_in_its_name"));
    expectPlain(*tableOf(gzip(kPlain.substr(0, 25)) + gzip(kPlain.substr(25)))); // two members
    expectPlain(*tableOf(replaced(kPlain, "\n", "\r\n")));
    expectPlain(*tableOf(replaced(kPlain, "\n", "\r")));
    expectPlain(*tableOf("\n\n" + replaced(kPlain, "\n", "\n\n")));
}

TEST(Reading, TakesSeparatorsAndDecimalCommas) {
    expectPlain(*tableOf(replaced(kPlain, ",", ";")));
    expectPlain(*tableOf(replaced(kPlain, ",", "\t")));
    expectPlain(*tableOf(replaced(replaced(kPlain, ",", ";"), ".", ",")));
    expectPlain(*tableOf(replaced(replaced(kPlain, ",", "\t"), ".", ",")));
    expectPlain(*tableOf("time_s, l1_mm ,event\n 0 , 1.5 ,\n0.5, -2.25,start\n1,+1e3,\n"));
    const auto mixed = tableOf("a;b\n1.234,5;1\n2,5;2\n");
    EXPECT_TRUE(std::isnan(numbersOf(*mixed, "a")[0])) << "a thousands' point is no number";
    EXPECT_EQ(numbersOf(*mixed, "a")[1], 2.5);
    EXPECT_THAT(problemsOf(*mixed), ElementsAre("2: a: \"1.234,5\" is not a number"));
}

TEST(Reading, TakesQuotes) {
    const auto table = tableOf("\"time_s\",\"a, b\",\"event\"\n0,\"1.5\",\"say \"\"hi\"\"\"\n"
                               "1,2,\"two\nlines, here\"\n2,3,5\" pipe\n3,x,z\n");
    EXPECT_THAT(namesOf(*table), ElementsAre("time_s", "a, b", "event"));
    EXPECT_THAT(wordsOf(*table, "event"), ElementsAre("say \"hi\"", "two\nlines, here", "5\" pipe", "z"));
    EXPECT_EQ(table->lineOf(1), 3);
    EXPECT_EQ(table->lineOf(2), 5) << "the row before takes two lines";
    EXPECT_THAT(problemsOf(*table), ElementsAre("6: a, b: \"x\" is not a number"));
}

TEST(Reading, TakesCommentsUnitsAndNoHeader) {
    expectPlain(*tableOf("# made by X\n# on a day, by night\n" + kPlain));
    const auto units = tableOf("time,l1,note\ns,mm,\n0,1,a\n1,2,b\n");
    EXPECT_THAT(numbersOf(*units, "l1"), ElementsAre(1.0, 2.0));
    EXPECT_EQ(units->columns()[1].info().unit, "mm");
    EXPECT_THAT(problemsOf(*units), IsEmpty());
    const auto brackets = tableOf("t [ms],l1 [mm],l2 (in),l3_m,alpha [rad]\n0,1,2,3,4\n500,1,2,3,4\n");
    EXPECT_EQ(brackets->columns()[1].info().label, "l1");
    EXPECT_EQ(brackets->columns()[2].info().unit, "in");
    EXPECT_EQ(brackets->columns()[3].info().unit, "m");
    EXPECT_EQ(brackets->columns()[4].info().unit, "rad");
    EXPECT_DOUBLE_EQ(brackets->time().end(), 0.5);
    const auto bare = tableOf("0,1,2\n1,3,4\n");
    EXPECT_THAT(namesOf(*bare), ElementsAre("column 1", "column 2", "column 3"));
    EXPECT_EQ(bare->rowCount(), 2U);
    EXPECT_FALSE(bare->time().hasTime());
    EXPECT_EQ(bare->time().seconds(1), 1.0) << "the number of the row";
    const auto commented = tableOf("# t,l1\n0,1\n1,3\n");
    EXPECT_THAT(namesOf(*commented), ElementsAre("t", "l1"));
    EXPECT_EQ(commented->rowCount(), 2U);
}

TEST(Reading, TakesTimesExactly) {
    const auto iso = tableOf("time,l1\n2026-11-29T12:00:00.123456789Z,1\n2026-11-29 14:00:01+02:00,2\n");
    EXPECT_TRUE(iso->time().isCalendar());
    EXPECT_EQ(iso->columns()[0].time(0), 1795953600123456789);
    EXPECT_EQ(iso->columns()[0].time(1), 1795953601000000000);
    EXPECT_NEAR(iso->time().seconds(1), 0.876543211, 1e-12);
    const auto nanos = tableOf("timestamp,l1\n1795953600123456789,1\n1795953600123456790,2\n");
    EXPECT_EQ(nanos->columns()[0].time(1) - nanos->columns()[0].time(0), 1);
    const auto millis = tableOf("timestamp,l1\n1795953600123,1\n1795953600124,2\n");
    EXPECT_EQ(millis->columns()[0].time(0), 1795953600123000000);
    const auto micros = tableOf("t_us,l1\n5,1\n7,2\n");
    EXPECT_EQ(micros->columns()[0].time(1), 7000);
    EXPECT_FALSE(micros->time().isCalendar());
    const auto none = tableOf("l1,l2\n5,1\n7,2\n");
    EXPECT_FALSE(none->time().hasTime());
}

TEST(Reading, ReportsTimesThatGoBackOrRepeat) {
    const auto table = tableOf("time_s,a\n0,1\n1,2\n1,3\n0.5,4\n2,5\n");
    EXPECT_THAT(numbersOf(*table, "a"), ElementsAre(1, 2, 3, 4, 5)) << "the order is the file's";
    EXPECT_THAT(problemsOf(*table), ElementsAre("4: time_s: time is repeated", "5: time_s: time goes back"));
    ASSERT_EQ(table->time().runs().size(), 2U);
    EXPECT_EQ(table->time().runs()[1], (RowRange{3, 5}));
    EXPECT_EQ(table->time().end(), 2.0);
}

TEST(Reading, NamesColumnsApart) {
    const auto table = tableOf("time_s,a,,a,a\n0,1,2,3,4\n");
    EXPECT_THAT(namesOf(*table), ElementsAre("time_s", "a", "column 3", "a (2)", "a (3)"));
    EXPECT_THAT(problemsOf(*table),
                ElementsAre("1: the name is there already; the column is called \"a (2)\"",
                            "1: the name is there already; the column is called \"a (3)\"",
                            "1: a column without a name is called \"column 3\""));
}

TEST(Reading, KeepsEveryDouble) {
    const auto table =
        tableOf("t,a\n0,1e308\n1,-1e308\n2,-0\n3,4.9e-324\n4,0.1\n5,1e400\n6,nan\n7,inf\n8,0x10\n");
    const std::vector<double> numbers = numbersOf(*table, "a");
    EXPECT_EQ(numbers[0], 1e308);
    EXPECT_EQ(numbers[1], -1e308);
    EXPECT_TRUE(numbers[2] == 0.0 && std::signbit(numbers[2]));
    EXPECT_EQ(numbers[3], 4.9e-324);
    EXPECT_EQ(numbers[4], 0.1);
    for (std::size_t i = 5; i < 9; ++i)
        EXPECT_TRUE(std::isnan(numbers[i])) << i;
    EXPECT_EQ(table->problems().cellsMissing, 4U);
}

TEST(Reading, TakesWideAndTinyFiles) {
    std::string header = "time_s", row = "0";
    for (int i = 0; i < 300; ++i) {
        header += ",c" + std::to_string(i);
        row += "," + std::to_string(i) + ".5";
    }
    const auto wide = tableOf(header + "\n" + row + "\n");
    EXPECT_EQ(wide->columns().size(), 301U);
    EXPECT_EQ(numbersOf(*wide, "c299")[0], 299.5);
    EXPECT_EQ(tableOf("time_s,l1_mm\n")->rowCount(), 0U);
    EXPECT_EQ(tableOf("time_s,l1_mm")->rowCount(), 0U);
    EXPECT_EQ(tableOf("time_s,l1_mm\n0,1\n")->rowCount(), 1U);
    EXPECT_EQ(tableOf("a\n1\n2\n")->rowCount(), 2U);
}

TEST(Reading, RefusesWhatIsNoTable) {
    const Folder folder;
    const auto refusal = [](const std::filesystem::path& file) -> std::string {
        try {
            loadTable(file);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(refusal(folder.write("empty.csv", "")), HasSubstr("empty.csv: is empty"));
    EXPECT_THAT(refusal(folder.write("blank.csv", "\n\n")), HasSubstr("blank.csv: is empty"));
    EXPECT_THAT(refusal(folder / ""), HasSubstr("is a directory"));
    EXPECT_THAT(refusal(folder / "absent.csv"), HasSubstr("absent.csv: cannot be read: No such file"));
    EXPECT_THAT(refusal("/dev/zero"), HasSubstr("/dev/zero: is a device, not a file"));
    EXPECT_THAT(refusal(folder.write("cut.gz", gzip(kPlain).substr(0, 4))), HasSubstr("cut.gz"));
}

} // namespace
} // namespace hexapose
