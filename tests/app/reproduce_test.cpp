// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// hexapose-cli reproduce: what it writes, and that it writes the same again.
#include "tests/app/machine.h"
#include "tests/app/process.h"
#include "tests/app/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hexapose::apptest {
namespace {

namespace fs = std::filesystem;

TEST(Reproduce, WritesTextCsvAndPictures) {
    const Scratch scratch;
    const std::string directory = scratch.path("to/be/made");
    const Outcome outcome = cli({"reproduce", "figure3", "--out", directory});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "") << "no progress bar where nobody watches";
    const fs::path stem = fs::path(directory) / "figure3";
    EXPECT_EQ(readText(stem.string() + ".txt"), outcome.out);
    EXPECT_EQ(Table(readText(stem.string() + ".csv")).rows.size(), 201U);
    EXPECT_TRUE(readText(stem.string() + ".png").starts_with("\x89PNG"));
    EXPECT_THAT(readText(stem.string() + ".svg"), testing::HasSubstr("<svg"));
    EXPECT_FALSE(fs::exists(fs::path(directory) / "reproduction.pdf")) << "that is for all";
}

TEST(Reproduce, Table5AgreesAndIsTheSameAgainForTheSamePlatformUnderAnotherName) {
    const Scratch scratch;
    Machine renamed = laboratory();
    renamed.name = "Ours";
    const std::string file = scratch.file("ours.toml", renamed.toml());
    const Outcome first = cli({"reproduce", "table5", "--out", scratch.path("first")});
    const Outcome second = cli({"reproduce", "table5", "--out", scratch.path("second"), "--platform", file});
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_THAT(first.out, testing::HasSubstr("misprint of 0.0869"));
    EXPECT_EQ(second.status, 0) << second.err;
    EXPECT_EQ(first.out, second.out);
    for (const std::string ending : {"txt", "csv", "png", "svg"})
        EXPECT_EQ(readText(scratch.path("first/table5." + ending)),
                  readText(scratch.path("second/table5." + ending)));

    const Table table(readText(scratch.path("first/table5.csv")));
    ASSERT_EQ(table.rows.size(), 6U);
    EXPECT_EQ(table.number(2, "published"), 0.0896);
    for (const char* method : {"newton-as-published", "newton", "mpr2-nr", "mpr3-nr"}) {
        EXPECT_NEAR(table.number(2, method), 0.08689, 1e-5);
        EXPECT_NEAR(table.number(5, method), table.number(5, "published"), 1e-4);
    }
}

} // namespace
} // namespace hexapose::apptest
