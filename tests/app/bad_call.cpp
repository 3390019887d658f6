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

} // namespace

void expectRefused(const std::string& program, const Scratch& scratch, const std::vector<BadCall>& calls) {
    const auto before = scratch.contents();
    for (const BadCall& call : calls) {
        SCOPED_TRACE(call.words);
        std::vector<std::string> words{program};
        std::istringstream stream(call.words);
        for (std::string word; stream >> word;)
            words.push_back(word == "''" ? "" : inScratch(word, scratch));
        std::vector<std::string> said;
        for (const std::string& part : call.said)
            said.push_back(inScratch(part, scratch));
        Process process(words, call.input);
        const Outcome outcome = process.wait();
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(notOneLineWith(outcome.err, said), "");
        EXPECT_EQ(scratch.contents(), before);
    }
}

} // namespace hexapose::apptest
