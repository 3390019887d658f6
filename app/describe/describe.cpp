// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/describe/describe.h"

#include "app/describe/forms.h"

#include <array>
#include <cstdio>
#include <utility>

namespace hexapose {

int printDescription(const ProgramDescription& program, std::string_view form) {
    constexpr int kBadInput = 2;
    constexpr std::array<std::pair<std::string_view, std::string (*)(const ProgramDescription&)>, 4> kForms{
        {{"man", manOptions}, {"bash", bashCompletion}, {"zsh", zshCompletion}, {"fish", fishCompletion}}};
    for (const auto& [word, make] : kForms) {
        if (form == word) {
            std::fputs(make(program).c_str(), stdout);
            return 0;
        }
    }
    std::fprintf(stderr, "%s: --describe: '%.*s' is none of man, bash, zsh and fish\n", program.name.c_str(),
                 static_cast<int>(form.size()), form.data());
    return kBadInput;
}

std::vector<OptionSpec> ownOptions() {
    return {{"help", "", "Show this help."}, {"version", "", "Show the version."}};
}

std::vector<std::string> switchesOf(const std::vector<OptionSpec>& options) {
    std::vector<std::string> words;
    for (const OptionSpec& option : options) {
        words.push_back(std::string("--") + option.name);
        if (words.back() == "--help")
            words.emplace_back("-h");
    }
    return words;
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? std::string() : std::string(between)) + word;
    return text;
}

std::string replaced(std::string text, std::string_view part, std::string_view by) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
        text.replace(at, part.size(), by);
    return text;
}

std::string functionName(const ProgramDescription& program) {
    return "_" + replaced(program.name, "-", "_");
}

} // namespace hexapose
