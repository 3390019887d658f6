// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The manual's page about the command line names every option that the programs know, and no other.

#include "tests/app/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace hexapose::apptest {
namespace {

std::string fileText(const char* file) {
    std::ifstream in(std::string(HEXAPOSE_SOURCE_DIR "/") + file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string page() {
    return fileText("resources/manual/command-line.md");
}

std::set<std::string> optionsIn(const std::string& text) {
    static const std::regex option("--[a-z][a-z-]+");
    std::set<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), option), end; it != end; ++it)
        found.insert(it->str());
    return found;
}

/// From "## NAME" to the next heading of its rank.
std::string section(const std::string& name) {
    const std::string text = page();
    const std::size_t begin = text.find("\n## " + name + "\n");
    if (begin == std::string::npos)
        return {};
    return text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

TEST(Manual, NamesEveryOptionOfTheCommandLineAndNoOther) {
    // Told once for all commands.
    const std::set<std::string> common{"--help", "--help-all", "--platform"};
    const std::set<std::string> solver{"--method",         "--model", "--tolerance-mm",
                                       "--max-iterations", "--steps", "--form"};
    std::set<std::string> all;
    const std::string help = cli({"--help"}).out;
    static const std::regex command("^  ([a-z]+) ");
    std::istringstream lines(help);
    int commands = 0;
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (!std::regex_search(line, found, command))
            continue;
        ++commands;
        const std::string text = section(found[1]);
        EXPECT_NE(text, "") << found[1];
        const std::set<std::string> told = optionsIn(text);
        std::set<std::string> known = optionsIn(cli({found[1], "--help"}).out);
        for (const std::string& option : known) {
            const bool elsewhere = common.contains(option) ||
                                   (solver.contains(option) && text.find("solver") != std::string::npos);
            EXPECT_TRUE(told.contains(option) || elsewhere) << found[1] << ' ' << option;
        }
        known.insert(common.begin(), common.end());
        known.insert(solver.begin(), solver.end());
        for (const std::string& option : told)
            EXPECT_TRUE(known.contains(option)) << found[1] << " has no " << option;
    }
    EXPECT_GE(commands, 9);
}

#ifdef HEXAPOSE_CONSOLE
TEST(Manual, NamesEveryOptionOfTheConsoleAndNoOther) {
    std::set<std::string> known = optionsIn(Process({HEXAPOSE_CONSOLE, "--help"}).wait().out);
    known.erase("--help");
    known.erase("--version");
    EXPECT_EQ(optionsIn(section("hexapose")), known);
}
#endif

#ifdef HEXAPOSE_VIEWER
TEST(Manual, NamesEveryOptionOfTheViewerAndNoOther) {
    std::set<std::string> known = optionsIn(Process({HEXAPOSE_VIEWER, "--help"}).wait().out);
    known.erase("--help");
    known.erase("--version");
    EXPECT_EQ(optionsIn(section("hexapose-viewer")), known);
}
#endif

} // namespace
} // namespace hexapose::apptest
