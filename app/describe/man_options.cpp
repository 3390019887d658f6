// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/describe/forms.h"

#include <cctype>

namespace hexapose {

namespace {

/// For roff: a '-' that is typed, no escapes, no line that is taken for a request. A list without blanks may
/// be broken behind ',' and '|'.
std::string inRoff(const std::string& text) {
    std::string out = text[0] == '.' || text[0] == '\'' ? "\\&" : "";
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
        if ((c == ',' || c == '|') && i + 1 < text.size() && text[i + 1] != ' ')
            out += "\\:";
    }
    return out;
}

/// "leg lengths of poses" as a sentence.
std::string sentence(std::string text) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text + ".";
}

void appendOption(std::string& out, const OptionSpec& option) {
    std::string typed = joined(switchesOf({option}), ", ");
    out += ".TP\n\\fB" + inRoff(typed) + "\\fR";
    if (*option.value != '\0')
        out += " \\fI" + inRoff(option.value) + "\\fR";
    out += "\n" + inRoff(option.help) + "\n";
}

void appendOptions(std::string& out, const std::vector<OptionSpec>& options) {
    for (const OptionSpec& option : options)
        appendOption(out, option);
}

} // namespace

std::string manOptions(const ProgramDescription& program) {
    std::string out;
    if (program.commands.empty()) {
        out += ".SH OPTIONS\n";
        appendOptions(out, program.usage.allOptions());
        return out;
    }
    out += ".SH OPTIONS\nOf the program itself; those of a command follow its name.\n";
    appendOptions(out, ownOptions());
    out += ".SH COMMANDS\n";
    for (const ProgramDescription::Command& command : program.commands) {
        out += ".SS \\fB" + inRoff(command.name) + "\\fR [\\fIoptions\\fR]";
        for (const QString& operand : command.usage.operands)
            out += " \\fI" + inRoff(operand.toStdString()) + "\\fR";
        out += "\n" + inRoff(sentence(command.summary)) + "\n";
        appendOptions(out, command.usage.allOptions());
    }
    return out;
}

} // namespace hexapose
