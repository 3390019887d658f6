// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Man pages and completions know every option that --help names, and no other; shells accept and use them.

#include "tests/app/process.h"
#include "tests/app/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

namespace hexapose::apptest {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

using Words = std::vector<std::string>;

std::vector<std::string> programs() {
    std::vector<std::string> all{HEXAPOSE_CLI};
#ifdef HEXAPOSE_CONSOLE
    all.emplace_back(HEXAPOSE_CONSOLE);
#endif
#ifdef HEXAPOSE_VIEWER
    all.emplace_back(HEXAPOSE_VIEWER);
#endif
    return all;
}

std::string said(const Words& call) {
    const Outcome outcome = Process(call).wait();
    EXPECT_EQ(outcome.status, 0) << testing::PrintToString(call) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
}

std::string description(const std::string& program, const std::string& form) {
    return said({program, "--describe", form});
}

std::set<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it)
        found.insert((*it)[1]);
    return found;
}

/// Of a text that has them as they are typed, without the dashes.
std::set<std::string> typed(const std::string& text) {
    return matches(text, "--([a-z][a-z-]+)");
}

/// Of fish's completion, in those of its rules that hold a text.
std::set<std::string> inFish(const std::string& completion, const std::string& text) {
    std::set<std::string> found;
    std::istringstream lines(completion);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("complete ") && line.find(text) != std::string::npos)
            found.merge(matches(line, " -l ([a-z][a-z-]+)"));
    return found;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t at = text.find(begin);
    EXPECT_NE(at, std::string::npos) << begin;
    if (at == std::string::npos)
        return {};
    return text.substr(at + begin.size(), text.find(end, at + begin.size()) - at - begin.size());
}

std::set<std::string> commands() {
    std::set<std::string> found;
    std::istringstream lines(between(cli({"--help"}).out, "Commands:\n", "\n\n"));
    for (std::string name, rest; lines >> name && std::getline(lines, rest);)
        found.insert(name);
    EXPECT_GE(found.size(), 9U);
    return found;
}

TEST(Describe, EveryCommandHasTheOptionsOfItsHelpInManPageAndCompletions) {
    const std::string man = std::regex_replace(description(HEXAPOSE_CLI, "man"), std::regex(R"(\\-)"), "-");
    const std::string bash = description(HEXAPOSE_CLI, "bash");
    const std::string zsh = description(HEXAPOSE_CLI, "zsh");
    const std::string fish = description(HEXAPOSE_CLI, "fish");
    for (const std::string& command : commands()) {
        const std::set<std::string> known = typed(cli({command, "--help"}).out);
        EXPECT_EQ(typed(between(man, ".SS \\fB" + command + "\\fR", "\n.SS")), known) << command;
        EXPECT_EQ(typed(between(bash, "\n    " + command + ")\n", "\n        ;;")), known) << command;
        EXPECT_EQ(typed(between(zsh, "\n    " + command + ")\n", "\n      ;;")), known) << command;
        EXPECT_EQ(inFish(fish, "_runs " + command), known) << command;
    }
}

TEST(Describe, AProgramWithAWindowHasTheOptionsOfItsHelpInManPageAndCompletions) {
    for (const std::string& program : programs()) {
        if (program == HEXAPOSE_CLI)
            continue;
        const std::set<std::string> known = typed(said({program, "--help"}));
        EXPECT_GE(known.size(), 9U) << program;
        EXPECT_EQ(typed(std::regex_replace(description(program, "man"), std::regex(R"(\\-)"), "-")), known);
        EXPECT_EQ(typed(description(program, "bash")), known);
        EXPECT_EQ(typed(description(program, "zsh")), known);
        EXPECT_EQ(inFish(description(program, "fish"), ""), known);
    }
}

TEST(Describe, ShellsThatAreInstalledAcceptTheirCompletion) {
    const Scratch scratch;
    for (const std::string& program : programs()) {
        for (const std::string shell : {"bash", "zsh", "fish"}) {
            if (Process({"/bin/sh", "-c", "command -v " + shell}).wait().status != 0)
                continue;
            const std::string file = scratch.file("completion." + shell, description(program, shell));
            const Outcome outcome = Process({"/bin/sh", "-c", shell + " -n " + file}).wait();
            EXPECT_EQ(outcome.status, 0) << program << ' ' << shell;
            EXPECT_EQ(outcome.err, "") << program << ' ' << shell;
        }
    }
}

/// What bash offers for the last of the words, in a folder with poses.csv, notes.txt and runs/.
class BashCompletion : public testing::Test {
protected:
    BashCompletion() {
        folder.file("poses.csv", "");
        folder.file("notes.txt", "");
        std::filesystem::create_directory(folder.path("runs"));
        script = files.file("completion.bash", description(HEXAPOSE_CLI, "bash"));
    }

    Words offered(const std::string& words) const {
        const std::string call = "cd " + folder.path("") + " && source " + script + " && COMP_WORDS=(" +
                                 words +
                                 ") && COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) && _hexapose_cli && "
                                 "((${#COMPREPLY[@]} == 0)) || printf '%s\\n' \"${COMPREPLY[@]}\"";
        std::istringstream lines(said({"/bin/bash", "-c", call}));
        Words found;
        for (std::string line; std::getline(lines, line);)
            found.push_back(line);
        return found;
    }

    const Scratch folder;
    const Scratch files;
    std::string script;
};

TEST_F(BashCompletion, OffersCommandsThenOptionsThatAreNotGivenYet) {
    EXPECT_THAT(offered("hexapose-cli f"), ElementsAre("forward"));
    EXPECT_THAT(offered("hexapose-cli --v"), ElementsAre("--version"));
    EXPECT_THAT(offered("hexapose-cli run --me"), ElementsAre("--method"));
    EXPECT_THAT(offered("hexapose-cli run --method newton --me"), ElementsAre());
    EXPECT_THAT(offered("hexapose-cli run ''"), IsSupersetOf({"--port", "--targets"}));
}

TEST_F(BashCompletion, OffersTheValuesThatAnOptionTakes) {
    EXPECT_THAT(offered("hexapose-cli run --mode ''"), ElementsAre("joint", "workspace"));
    EXPECT_THAT(offered("hexapose-cli run --mode = w"), ElementsAre("workspace"));
    EXPECT_THAT(offered("hexapose-cli run --steps ''"), ElementsAre());
    EXPECT_THAT(offered("hexapose-cli run --targets ''"), ElementsAre("poses.csv", "runs"));
    EXPECT_THAT(offered("hexapose-cli run --targets n"), ElementsAre("notes.txt"));
    EXPECT_THAT(offered("hexapose-cli run --report ''"), ElementsAre("runs"));
    EXPECT_THAT(offered("hexapose-cli run --platform ''"),
                ElementsAre("laboratory", "notes.txt", "poses.csv", "runs"));
    EXPECT_THAT(offered("hexapose-cli track --mechanism 3"), ElementsAre("3-rps", "3-ups-s"));
}

TEST_F(BashCompletion, OffersWhatACommandReads) {
    EXPECT_THAT(offered("hexapose-cli forward ''"), ElementsAre("poses.csv", "runs"));
    EXPECT_THAT(offered("hexapose-cli reproduce table"), ElementsAre("table2", "table3", "table4", "table5"));
    EXPECT_THAT(offered("hexapose-cli experiment ''"), ElementsAre("closed-loop"));
}

TEST_F(BashCompletion, OffersMethodsThatForwardKnows) {
    const Words methods = offered("hexapose-cli forward --method ''");
    EXPECT_THAT(methods, IsSupersetOf({"mpr3-nr", "newton", "fsi"}));
    const std::string empty = folder.file("none.csv", "l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n");
    for (const std::string& method : methods) {
        const Outcome outcome = cli({"forward", "--method", method, empty});
        EXPECT_THAT(outcome.err, Not(HasSubstr("--method"))) << method;
    }
}

TEST(Describe, RefusesAnotherForm) {
    for (const std::string& program : programs()) {
        const Outcome outcome = Process({program, "--describe", "html"}).wait();
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(notOneLineWith(outcome.err, {"--describe", "html"}), "");
    }
}

} // namespace
} // namespace hexapose::apptest
