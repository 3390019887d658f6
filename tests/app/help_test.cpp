// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hexapose::apptest {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Help, OfACommandNamesTheCommandAndWhatItTakes) {
    const std::vector<std::pair<std::string, std::string>> calls = {
        {"inverse", "hexapose-cli inverse [options] POSES.csv\n"},
        {"forward", "hexapose-cli forward [options] LENGTHS.csv\n"},
        {"train", "hexapose-cli train [options]\n"},
        {"simulate", "hexapose-cli simulate [options]\n"},
        {"run", "hexapose-cli run [options]\n"},
        {"report", "hexapose-cli report [options] LOG.csv\n"},
        {"summary", "hexapose-cli summary [options] LOG.csv\n"},
        {"verify", "hexapose-cli verify [options] LOG.csv\n"},
        {"compare", "hexapose-cli compare [options] A.csv B.csv\n"},
        {"track", "hexapose-cli track [options]\n"},
        {"reproduce", "hexapose-cli reproduce [options] "},
        {"experiment", "hexapose-cli experiment [options] closed-loop\n"}};
    for (const auto& [command, usage] : calls) {
        for (const char* word : {"--help", "-h"}) {
            const Outcome outcome = cli({command, word});
            EXPECT_EQ(outcome.status, 0) << command;
            EXPECT_EQ(outcome.err, "") << command;
            EXPECT_THAT(outcome.out, StartsWith("Usage: " + usage));
            EXPECT_EQ(outcome.out.find("--platform <NAME|FILE>") != std::string::npos,
                      command != "summary" && command != "compare")
                << command;
        }
    }
}

} // namespace
} // namespace hexapose::apptest
