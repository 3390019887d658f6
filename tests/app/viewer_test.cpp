// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The viewer as a program, without a display.
#include "tests/app/process.h"
#include "tests/app/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace hexapose::apptest {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class ViewerTest : public ::testing::Test {
protected:
    std::string write(const std::string& name, const std::string& text) const {
        return m_scratch.file(name, text);
    }
    std::string target(const std::string& name) const { return m_scratch.path(name); }
    static Outcome viewer(std::vector<std::string> words) {
        words.insert(words.begin(), HEXAPOSE_VIEWER);
        return Process(words).wait();
    }

private:
    Scratch m_scratch;
};

const std::string kGood = "time_s,l1_mm,q\n0,1.50,1\n1,2.50,1\n2,3.50,1\n";

TEST_F(ViewerTest, ExportsEachKindOfAGoodLog) {
    const std::string log = write("run.csv", kGood);
    for (const auto& [name, begin] : std::vector<std::pair<std::string, std::string>>{
             {"a.png", "\x89PNG"}, {"a.svg", "<?xml"}, {"a.pdf", "%PDF-"}, {"a.csv", "time_s,l1_mm,q\n"}}) {
        const Outcome outcome = viewer({"--export", target(name), log});
        EXPECT_EQ(outcome.status, 0) << name << outcome.err;
        EXPECT_THAT(outcome.err, IsEmpty());
        EXPECT_THAT(readText(target(name)), StartsWith(begin));
    }
    EXPECT_EQ(readText(target("a.csv")), kGood);
}

TEST_F(ViewerTest, ExportsASpanAndCharts) {
    const std::string log = write("run.csv", kGood);
    EXPECT_EQ(viewer({"--export", target("a.csv"), "--from", "1", "--to", "1.5", log}).status, 0);
    EXPECT_EQ(readText(target("a.csv")), "time_s,l1_mm,q\n1,2.50,1\n");
    EXPECT_EQ(viewer({"--export", target("a.svg"), "--charts", "legs", log}).status, 0);
    EXPECT_THAT(readText(target("a.svg")), HasSubstr("Legs"));
    const Outcome unknown = viewer({"--export", target("a.svg"), "--charts", "nothing", log});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(notOneLineWith(unknown.err, {"nothing"}), "");
}

TEST_F(ViewerTest, TellsWhatIsMissingAndWhatCannotBeRead) {
    const Outcome some =
        viewer({"--export", target("a.png"), write("bad.csv", kGood + "3,oops,1\n4,1\n5,1,1\n")});
    EXPECT_EQ(some.status, 1);
    EXPECT_THAT(some.err, HasSubstr("bad.csv:5: "));
    EXPECT_THAT(some.err, HasSubstr("bad.csv:6: "));
    EXPECT_TRUE(std::filesystem::exists(target("a.png")));
    const Outcome none = viewer({"--export", target("b.png"), target("no-such.csv")});
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(notOneLineWith(none.err, {"no-such.csv"}), "");
    EXPECT_FALSE(std::filesystem::exists(target("b.png")));
}

TEST_F(ViewerTest, RefusesWhatDoesNotFit) {
    const std::string log = write("run.csv", kGood);
    const std::vector<std::vector<std::string>> calls{
        {"--export", target("a.txt"), log},
        {"--export", target("a.png")},
        {"--export", target("a.png"), log, log},
        {"--export", target("a.png"), "--from", "x", log},
        {"--export", target("a.png"), "--from", "2", "--to", "1", log},
        {"--export", target("no/folder/a.png"), log},
        {"--export", target("a.png"), "--layout", log, log},
        {"--language", "xx", log},
        {"--platform", "laboratory", log}};
    for (const auto& call : calls) {
        const Outcome outcome = viewer(call);
        EXPECT_EQ(outcome.status, 2) << testing::PrintToString(call);
        EXPECT_EQ(notOneLineWith(outcome.err, {"hexapose-viewer: "}), "") << testing::PrintToString(call);
    }
}

TEST_F(ViewerTest, WithoutADisplayItSaysSo) {
    const Outcome outcome = Process({HEXAPOSE_VIEWER, write("run.csv", kGood)}, {},
                                    {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"QT_QPA_PLATFORM", ""}})
                                .wait();
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(notOneLineWith(outcome.err, {"display", "--export"}), "");
}

} // namespace
} // namespace hexapose::apptest
