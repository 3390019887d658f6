// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/describe/forms.h"
#include "app/describe/values.h"

namespace hexapose {

namespace {

/// @ stands for the name of the program's function. Fish asks for the value of --option=value with all of it.
constexpr const char* kFishHelpers = R"shell(
function @_paths
    complete -C "@_nothing "(string replace -r -- '^--[^=]*=' '' (commandline -ct))
end

# Files whose names end so first.
function @_files
    set -l paths (@_paths)
    string match -e -r -- (string escape --style=regex -- $argv[1])'$' $paths
    string match -e -r -- '/$' $paths
    string match -e -r -v -- '(/|'(string escape --style=regex -- $argv[1])')$' $paths
end

function @_folders
    string match -e -r -- '/$' (@_paths)
end

)shell";

constexpr const char* kFishRuns =
    R"shell(# The command is the first word, and no other one: a file can be called like a command.
function @_runs
    set -l words (commandline -opc)
    test (count $words) -ge 2; and test $words[2] = $argv[1]
end

)shell";

/// Within single quotes.
std::string fishQuoted(const std::string& text) {
    return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

/// What offers these values: files of all names by -F, the rest by -a.
std::string fishOffers(const std::string& function, const Values& values) {
    std::vector<std::string> all = values.words;
    const bool anyFile = values.files && values.suffix.empty();
    if (values.files && !anyFile)
        all.push_back("(" + function + "_files " + values.suffix + ")");
    else if (values.directories)
        all.push_back("(" + function + "_folders)");
    std::string out = anyFile ? " -F" : "";
    if (!all.empty())
        out += " -k -a " + fishQuoted(joined(all));
    return out;
}

/// `condition` is fish, and holds where these are taken; empty: always.
void appendTaken(std::string& out, const ProgramDescription& program, const std::string& condition,
                 const std::vector<OptionSpec>& options, const QStringList& operands) {
    const std::string function = "_" + functionName(program);
    const std::string begin = "complete -c " + program.name;
    for (const OptionSpec& option : options) {
        std::string when = condition;
        if (*option.value == '\0') // with a value: it would no longer be known when the value is typed
            when += std::string(when.empty() ? "" : "; and ") + "not __fish_seen_argument -l " + option.name;
        out += begin + (when.empty() ? "" : " -n " + fishQuoted(when));
        if (std::string_view(option.name) == "help")
            out += " -s h";
        out += std::string(" -l ") + option.name;
        if (*option.value != '\0') {
            const std::string values = fishOffers(function, valuesOf(option));
            out += (values.starts_with(" -F") ? " -r" : " -x") + values;
        }
        out += " -d " + fishQuoted(option.help) + "\n";
    }
    const std::string values = fishOffers(function, valuesOf(operands));
    if (!values.empty())
        out += begin + (condition.empty() ? "" : " -n " + fishQuoted(condition)) + values + "\n";
}

} // namespace

std::string fishCompletion(const ProgramDescription& program) {
    const std::string function = "_" + functionName(program);
    const bool hasCommands = !program.commands.empty();
    std::string out = "# Completion of " + program.name + " in fish, made from its tables of options.\n" +
                      replaced(std::string(kFishHelpers) + (hasCommands ? kFishRuns : ""), "@", function) +
                      "complete -c " + program.name + " -f\n";
    if (!hasCommands) {
        appendTaken(out, program, {}, program.usage.allOptions(), program.usage.operands);
        return out;
    }
    const std::string isCommand = function + "_runs";
    const std::string noCommand = "test (count (commandline -opc)) -eq 1";
    appendTaken(out, program, noCommand, ownOptions(), {});
    for (const ProgramDescription::Command& command : program.commands)
        out += "complete -c " + program.name + " -n " + fishQuoted(noCommand) + " -a " + command.name +
               " -d " + fishQuoted(command.summary) + "\n";
    for (const ProgramDescription::Command& command : program.commands)
        appendTaken(out, program, isCommand + " " + command.name, command.usage.allOptions(),
                    command.usage.operands);
    return out;
}

} // namespace hexapose
