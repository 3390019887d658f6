// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/bad_call.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

namespace hexapose::apptest {

namespace {

std::string inScratch(const std::string& text, const Scratch& scratch) {
    return std::regex_replace(text, std::regex("@"), scratch.path(""));
}

constexpr std::chrono::seconds kAtOnce{30};
using Contents = std::map<std::string, std::string>;

/// Names of the files that came, went or are no longer the same.
std::string changes(const Contents& before, const Contents& after) {
    std::string names;
    for (const auto& [name, text] : after)
        if (!before.contains(name) || before.at(name) != text)
            names += name + " ";
    for (const auto& [name, text] : before)
        names += after.contains(name) ? "" : name + " ";
    return names;
}

} // namespace

void expectRefused(const std::string& program, const Scratch& scratch, const std::vector<BadCall>& calls) {
    for (const BadCall& call : calls) {
        SCOPED_TRACE(call.words);
        std::vector<std::string> words{program};
        std::istringstream stream(call.words);
        for (std::string word; stream >> word;)
            words.push_back(word == "''" ? "" : inScratch(word, scratch));
        std::vector<std::string> said;
        for (const std::string& part : call.said)
            said.push_back(inScratch(part, scratch));
        const Contents before = scratch.contents();
        Process process(words, call.input);
        const Outcome outcome = process.wait(kAtOnce);
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(notOneLineWith(outcome.err, said), "");
        EXPECT_EQ(changes(before, scratch.contents()), "");
    }
}

} // namespace hexapose::apptest
