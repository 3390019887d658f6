// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Files that are cut, grow or hold rows that do not fit: nothing is lost silently, and no wrong number shown.

#include "tests/core/table/table_files.h"

#include <gmock/gmock.h>

#include <cmath>

namespace hexapose {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(DamagedFile, RowsThatDoNotFitAreLeftOutAndListed) {
    const auto table = tableOf("t,a,b\n0,1,2\n1,2\n2,3,4,5\n3,,6\n4,x,7\n5,8,9\n");
    EXPECT_THAT(numbersOf(*table, "b"), ElementsAre(2, 6, 7, 9));
    EXPECT_THAT(problemsOf(*table), ElementsAre("3: row left out: 2 fields, but the header has 3",
                                                "4: row left out: 4 fields, but the header has 3",
                                                "6: a: \"x\" is not a number"));
    EXPECT_EQ(table->problems().rowsLeftOut, 2U);
    EXPECT_EQ(table->problems().cellsMissing, 1U) << "an empty cell is none";
    EXPECT_EQ(table->lineOf(3), 7);
}

/// However much of the end is missing, what is shown was in the file.
TEST(DamagedFile, ACutNumberIsNeverShown) {
    const std::string whole = "t,a,b\n0.00,339.512,12\n0.01,339.634,345\n0.02,340.125,678\n";
    const std::vector<double> a{339.512, 339.634, 340.125}, b{12, 345, 678};
    const std::size_t begin = whole.find("0.01");
    for (std::size_t size = begin; size < whole.size(); ++size) {
        SCOPED_TRACE(whole.substr(begin, size - begin));
        const auto table = tableOf(whole.substr(0, size));
        ASSERT_GE(table->rowCount(), 1U);
        for (Row row = 0; row < table->rowCount(); ++row) {
            EXPECT_EQ(table->columns()[1].number(row), a[row]);
            const double shown = table->columns()[2].number(row);
            EXPECT_TRUE(std::isnan(shown) || shown == b[row]) << shown;
        }
        if (whole[size - 1] != '\n' && whole[size - 1] != ',') {
            EXPECT_EQ(table->problems().count, 1U);
        }
    }
    const auto decimals = tableOf("t,a\n0,1.25\n1,2.50\n2,3.75");
    EXPECT_THAT(numbersOf(*decimals, "a"), ElementsAre(1.25, 2.5, 3.75)) << "as many decimals as all: whole";
    EXPECT_THAT(problemsOf(*decimals), IsEmpty());
}

TEST(DamagedFile, AQuoteThatIsNeverClosedLosesItsRowOnly) {
    const auto table = tableOf("t,event\n0,a\n1,\"b\n");
    EXPECT_EQ(table->rowCount(), 1U);
    EXPECT_THAT(problemsOf(*table), ElementsAre("3: row left out: a quote is opened and never closed"));
}

TEST(DamagedFile, GzipThatEndsEarlyGivesWhatItHolds) {
    std::string text = "t,a\n";
    for (int i = 0; i < 100000; ++i)
        text += std::to_string(i) + "," + std::to_string(i * 7919 % 10007) + "\n";
    const std::string whole = gzip(text);
    const auto table = tableOf(whole.substr(0, whole.size() / 2));
    EXPECT_GT(table->rowCount(), 10000U);
    for (Row row = 0; row + 1 < table->rowCount(); ++row)
        ASSERT_EQ(table->columns()[1].number(row), static_cast<double>(row * 7919 % 10007));
    EXPECT_GE(table->problems().count, 1U);
}

TEST(DamagedFile, ManyProblemsAreCounted) {
    std::string text = "t,a\n";
    for (int i = 0; i < 30000; ++i)
        text += std::to_string(i) + ",x" + (i % 1000 == 0 ? "" : "1") + "\n" + std::to_string(i) + ".3,1\n" +
                std::to_string(i) + ".6,2\n";
    const auto table = tableOf(text);
    EXPECT_EQ(table->problems().first.size(), ProblemList::kMost);
    EXPECT_EQ(table->problems().count, 30000U);
    EXPECT_EQ(table->problems().cellsMissing, 30000U);
}

} // namespace
} // namespace hexapose
