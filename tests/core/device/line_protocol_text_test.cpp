// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The virtual platform does what the protocol's text says: its tables and its conversation, read and tried.

#include "core/base/text_file.h"
#include "core/device/simulation/line_controller.h"
#include "core/geometry/geometry_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using Row = std::vector<std::string>;
using ::testing::StartsWith;

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" `");
    return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" `") + 1 - begin);
}

std::vector<std::string> linesOfText() {
    std::istringstream text(readTextFile(HEXAPOSE_SOURCE_DIR "/resources/manual/protocol.md"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

/// The body of the table whose heading begins so, cells without blanks and backquotes.
std::vector<Row> tableUnder(const std::string& heading) {
    std::vector<Row> rows;
    bool inside = false;
    for (const std::string& line : linesOfText()) {
        inside = line.starts_with(heading) || (inside && line.starts_with("|"));
        if (!inside || line.starts_with(heading) || line.starts_with("|---"))
            continue;
        std::istringstream cells(line.substr(1));
        Row row;
        for (std::string cell; std::getline(cells, cell, '|');)
            row.push_back(trimmed(cell));
        rows.push_back(std::move(row));
    }
    return rows;
}

struct TextBench {
    LineController controller{
        VirtualPlatform(loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml")),
        {"Bench rig", 10ms}};
    std::chrono::nanoseconds now{0};

    /// The answer to one payload, or "none".
    std::string ask(const std::string& payload) {
        controller.takeFrames();
        controller.receive(line::frame(payload), now);
        const std::vector<std::string> frames = controller.takeFrames();
        EXPECT_LE(frames.size(), 1U);
        return frames.empty() ? "none" : frames[0].substr(1, frames[0].find('*') - 1);
    }
    void wait(std::chrono::nanoseconds duration) {
        now += duration;
        controller.step(now);
    }
    char state() const { return toLetter(controller.platform().state()); }

    /// Brought to a state, its legs referenced or, where that can be, not.
    void enter(char wanted, bool referenced) {
        if (referenced) {
            ask("HOME");
            wait(10ms);
        }
        if (wanted == 'E')
            ask("ENABLE");
        if (wanted == 'S')
            ask("STOP");
        if (wanted == 'F')
            controller.raiseFault("7", "drive 3 is hot");
        ASSERT_EQ(state(), wanted);
    }
};

/// "OK, U, when done D": the answer, the state after it, and the one that follows by itself. "D or U": if
/// referenced, if not.
void tryRequest(const std::string& payload, char before, const std::string& cell, bool referenced) {
    SCOPED_TRACE(payload + " in " + before + (referenced ? ", referenced: " : ", unreferenced: ") + cell);
    TextBench bench;
    bench.enter(before, referenced);
    const std::string type = payload.substr(0, payload.find(','));
    const std::string word = cell.substr(0, cell.find(','));
    const std::string expected = word == "STATE" ? "ERR," + type + ",STATE,"
                                 : word == "OK"  ? "OK," + type
                                                 : word;
    EXPECT_THAT(bench.ask(payload), StartsWith(expected));
    const std::string after = cell.substr(cell.find(',') + 2);
    const bool either = after.size() == 6 && after.substr(1, 4) == " or ";
    EXPECT_EQ(bench.state(), either && !referenced ? after[5] : after[0]);
    const bool moves = after.find("when done ") != std::string::npos;
    bench.wait(100ms);
    EXPECT_EQ(bench.state(), moves || !either ? after.back() : referenced ? after[0] : after[5]);
}

TEST(LineProtocolText, EveryRequestInEveryStateIsAnsweredAsTheTableSays) {
    const std::string states = "UDESF";
    const std::vector<Row> rows = tableUnder("| request | in `U`");
    ASSERT_EQ(rows.size(), 8U);
    for (const Row& row : rows) {
        ASSERT_EQ(row.size(), 1 + states.size()) << row[0];
        for (std::size_t s = 0; s < states.size(); ++s)
            for (const bool referenced : {true, false})
                if (referenced ? states[s] != 'U' : states[s] != 'D' && states[s] != 'E')
                    tryRequest(row[0], states[s], row[1 + s], referenced);
    }
}

TEST(LineProtocolText, TheFramesThatKeepTheWatchdogQuietAreThoseOfTheTable) {
    const std::vector<Row> rows = tableUnder("| payload, received in `E`");
    ASSERT_GE(rows.size(), 13U);
    for (const Row& row : rows) {
        ASSERT_EQ(row.size(), 3U) << row[0];
        SCOPED_TRACE(row[0]);
        TextBench bench;
        bench.enter('E', true);
        bench.wait(249ms);
        EXPECT_THAT(bench.ask(row[0]), StartsWith(row[1]));
        bench.wait(249ms);
        EXPECT_EQ(bench.state(), row[2] == "yes" ? 'E' : 'S');
        bench.wait(2ms);
        EXPECT_EQ(bench.state(), 'S');
    }
}

TEST(LineProtocolText, AHomeThatFailsLeavesTheLegsUnreferenced) {
    TextBench bench;
    bench.enter('D', true);
    EXPECT_EQ(bench.ask("HOME"), "OK,HOME");
    bench.controller.raiseFault("3", "no reference mark");
    EXPECT_EQ(bench.ask("CLEAR"), "OK,CLEAR");
    EXPECT_EQ(bench.state(), 'U');
}

TEST(LineProtocolText, TheEchoOutlivesHelloStopAndClear) {
    TextBench bench;
    bench.enter('E', true);
    bench.ask("SET,41,300,300,300,300,300,300");
    for (const std::string payload : {"HELLO,1", "STOP", "CLEAR", "ENABLE"})
        bench.ask(payload);
    bench.wait(10ms);
    EXPECT_THAT(bench.controller.takeFrames().back(), ::testing::HasSubstr(",E,41*"));
}

TEST(LineProtocolText, TheConversationHasTheRightChecksumsAndTheVirtualPlatformGivesItsAnswers) {
    TextBench bench;
    std::string answer;
    int requests = 0;
    for (const std::string& line : linesOfText()) {
        if (!line.starts_with("> $") && !line.starts_with("< $"))
            continue;
        const std::string payload = line.substr(3, line.find('*') - 3);
        EXPECT_EQ(line.substr(2) + "\n", line::frame(payload));
        if (line.starts_with('>')) {
            answer = bench.ask(payload);
            ++requests;
            bench.wait(10ms);
        } else if (payload.starts_with("LEN,")) {
            const line::LineMessage read = line::parsePayload(payload, line::Side::Host);
            ASSERT_TRUE(std::holds_alternative<line::Len>(read)) << payload;
            EXPECT_EQ(std::get<line::Len>(read).state, bench.controller.platform().state());
        } else {
            const bool refused = payload.starts_with("ERR,"); // whose text is free
            EXPECT_THAT(answer, StartsWith(refused ? payload.substr(0, payload.rfind(',') + 1) : payload));
        }
    }
    EXPECT_EQ(requests, 8);
}

} // namespace
} // namespace hexapose
