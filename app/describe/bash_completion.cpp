// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/describe/forms.h"
#include "app/describe/values.h"

namespace hexapose {

namespace {

/// What every completion begins with; @ stands for the name of its function.
constexpr const char* kBashHelpers = R"shell(
# Those of the words that begin as what is typed.
@_words() {
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$*" -- "$cur")
}

# Files whose names end so, any where there is none, and folders.
@_files() {
    local found
    compopt -o filenames 2>/dev/null
    mapfile -t found < <(compgen -f -X "!*$1" -- "$cur")
    ((${#found[@]})) || mapfile -t found < <(compgen -f -- "$cur")
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
        { ((${#found[@]} == 0)) || printf '%s\n' "${found[@]}"; compgen -d -- "$cur"; } | sort -u)
}

@_folders() {
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$cur")
}

# Options that are not given yet: none is taken twice.
@_options() {
    local option
    local -a left=()
    for option in "$@"; do
        [[ $given == *" $option "* ]] || left+=("$option")
    done
    @_words "${left[@]}"
}

@() {
    local IFS=$' \t\n'
    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]}
    local given=" ${COMP_WORDS[*]:1:COMP_CWORD - 1} ${COMP_WORDS[*]:COMP_CWORD + 1} "
    COMPREPLY=()
    # Bash takes the = between an option and its value for a word.
    if [[ $cur == = ]]; then
        cur=
    elif [[ $prev == = ]]; then
        prev=${COMP_WORDS[COMP_CWORD - 2]}
    fi
)shell";

/// The calls that offer these values.
std::string bashOffers(const std::string& function, const Values& values) {
    std::vector<std::string> calls;
    if (!values.words.empty())
        calls.push_back(function + "_words " + joined(values.words));
    if (values.files)
        calls.push_back(function + "_files" + (values.suffix.empty() ? "" : " " + values.suffix));
    else if (values.directories)
        calls.push_back(function + "_folders");
    return joined(calls, "; ");
}

/// After `prev`, its value; else operands where there are any and no '-' is typed; else options.
std::string bashCase(const std::string& function, const std::vector<OptionSpec>& options,
                     const QStringList& operands, const std::string& indent) {
    std::string out = indent + "case $prev in\n";
    for (const OptionSpec& option : options) {
        if (*option.value == '\0')
            continue;
        const std::string call = bashOffers(function, valuesOf(option));
        out += indent + "    --" + option.name + ") " + (call.empty() ? "" : call + "; ") + "return ;;\n";
    }
    out += indent + "esac\n";
    const std::string rest = function + "_options " + joined(switchesOf(options));
    const std::string operand = bashOffers(function, valuesOf(operands));
    if (operand.empty())
        return out + indent + rest + "\n";
    return out + indent + "if [[ $cur == -?* ]]; then\n" + indent + "    " + rest + "\n" + indent + "else\n" +
           indent + "    " + operand + "\n" + indent + "fi\n";
}

} // namespace

std::string bashCompletion(const ProgramDescription& program) {
    const std::string function = functionName(program);
    std::string out = "# Completion of " + program.name + " in bash, made from its tables of options.\n" +
                      replaced(kBashHelpers, "@_", function + "_");
    out = replaced(out, "\n@()", "\n" + function + "()");
    if (program.commands.empty()) {
        out += bashCase(function, program.usage.allOptions(), program.usage.operands, "    ");
    } else {
        std::vector<std::string> first;
        for (const ProgramDescription::Command& command : program.commands)
            first.push_back(command.name);
        for (const std::string& word : switchesOf(ownOptions()))
            first.push_back(word);
        out += "    if ((COMP_CWORD == 1)); then\n        " + function + "_words " + joined(first) +
               "\n        return\n    fi\n    case ${COMP_WORDS[1]} in\n";
        for (const ProgramDescription::Command& command : program.commands)
            out += "    " + command.name + ")\n" +
                   bashCase(function, command.usage.allOptions(), command.usage.operands, "        ") +
                   "        ;;\n";
        out += "    esac\n";
    }
    return out + "}\n\ncomplete -F " + function + " " + program.name + "\n";
}

} // namespace hexapose
