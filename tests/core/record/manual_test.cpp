// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The manual's page about files names every column of the log, every event and every state.

#include "core/base/text_file.h"
#include "core/record/event_codec.h"
#include "core/record/quantities.h"
#include "core/record/run_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hexapose {
namespace {

using ::testing::HasSubstr;

class ManualOfFiles : public ::testing::Test {
protected:
    const std::string m_page = readTextFile(HEXAPOSE_SOURCE_DIR "/resources/manual/files.md");
};

TEST_F(ManualOfFiles, NamesEveryColumnOfTheLog) {
    for (const Quantity& quantity : quantities())
        EXPECT_THAT(m_page, HasSubstr("`" + std::string(quantity.name) + "`"));
}

TEST_F(ManualOfFiles, NamesEveryEvent) {
    for (int code = 0; toWord(static_cast<EventCode>(code)) != "unknown"; ++code)
        EXPECT_THAT(m_page, HasSubstr("`" + std::string(toWord(static_cast<EventCode>(code))) + "`"));
}

TEST_F(ManualOfFiles, NamesEveryState) {
    for (int state = 0; toWord(static_cast<RunState>(state)) != "unknown"; ++state)
        EXPECT_THAT(m_page, HasSubstr("`" + std::string(toWord(static_cast<RunState>(state))) + "`"));
}

} // namespace
} // namespace hexapose
