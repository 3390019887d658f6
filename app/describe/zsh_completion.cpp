// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/describe/forms.h"
#include "app/describe/values.h"

namespace hexapose {

namespace {

/// Words, files and folders in one list; @ stands for the name of the program's function.
constexpr const char* kZshHelper = R"shell(
# @_values files|folders|none SUFFIX WORD...
@_values() {
  local kind=$1 suffix=$2
  shift 2
  local -a groups=()
  (( $# )) && groups+=("words:word:($*)")
  case $kind in
    files) groups+=("files:file:_files -g '*$suffix(-.)'") ;;
    folders) groups+=("folders:folder:_files -/") ;;
  esac
  _alternative $groups
}
)shell";

/// Within single quotes.
std::string zshQuoted(const std::string& text) {
    return "'" + replaced(text, "'", "'\\''") + "'";
}

std::string inBrackets(const std::string& text) {
    return replaced(replaced(replaced(text, "\\", "\\\\"), "[", "\\["), "]", "\\]");
}

std::string beforeColon(const std::string& text) {
    return replaced(replaced(text, "\\", "\\\\"), ":", "\\:");
}

/// ":what: how": a blank in front leaves the words of an action as they are.
std::string action(const std::string& function, const std::string& what, const Values& values) {
    std::string out = ":" + beforeColon(what) + ": ";
    if (values.none())
        return out;
    out += function + "_values " +
           (values.files         ? "files"
            : values.directories ? "folders"
                                 : "none") +
           " " + (values.suffix.empty() ? "\"\"" : values.suffix);
    for (const std::string& word : values.words)
        out += " " + beforeColon(word);
    return out;
}

std::string argumentsCall(const std::string& function, const std::vector<OptionSpec>& options,
                          const QStringList& operands, const std::string& indent) {
    std::string out = indent + "_arguments";
    const auto append = [&](const std::string& text) { out += " \\\n" + indent + "  " + text; };
    for (const OptionSpec& option : options) {
        const std::string help = "[" + inBrackets(option.help) + "]";
        const std::string name = std::string("--") + option.name;
        if (name == "--help")
            append("'(- *)'{-h,--help}" + zshQuoted(help));
        else if (*option.value == '\0')
            append(zshQuoted(name + help));
        else
            append(zshQuoted(name + "=" + help + action(function, option.value, valuesOf(option))));
    }
    for (const QString& operand : operands) {
        const std::string form = operand.toStdString();
        append(zshQuoted((form.ends_with("...") ? "*" : "") + action(function, form, valuesOf({operand}))));
    }
    return out + "\n";
}

} // namespace

std::string zshCompletion(const ProgramDescription& program) {
    const std::string function = functionName(program);
    std::string out = "#compdef " + program.name + "\n# Made from its tables of options.\n" +
                      replaced(kZshHelper, "@", function) + "\n" + function + "() {\n";
    if (program.commands.empty()) {
        out += argumentsCall(function, program.usage.allOptions(), program.usage.operands, "  ");
    } else {
        out += "  local -a commands=(\n";
        for (const ProgramDescription::Command& command : program.commands)
            out += "    " + zshQuoted(command.name + ":" + command.summary) + "\n";
        out += "  )\n  if (( CURRENT == 2 )); then\n    if [[ $PREFIX == -* ]]; then\n" +
               argumentsCall(function, ownOptions(), {}, "      ") +
               "    else\n      _describe -t commands command commands\n    fi\n    return\n  fi\n"
               "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $command in\n";
        for (const ProgramDescription::Command& command : program.commands)
            out += "    " + command.name + ")\n" +
                   argumentsCall(function, command.usage.allOptions(), command.usage.operands, "      ") +
                   "      ;;\n";
        out += "  esac\n";
    }
    return out + "}\n\n" + function + " \"$@\"\n";
}

} // namespace hexapose
