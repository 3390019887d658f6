// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <string>
#include <vector>

namespace hexapose {

/// An option: `--name VALUE`, or a switch when `value` is empty. `value` says what is taken, alternatives
/// apart by '|': a word in lower case is itself, FILE and PATH are any file, FILE.csv is one that ends so,
/// DIR is a folder, NAME is a file of this kind that is shipped, and any other word with a capital is shown
/// only (N, POSE). Shells complete by it.
struct OptionSpec {
    const char* name;
    const char* value;
    std::string help;
    std::vector<std::string> words = {}; ///< known values that `value` does not spell out
};

/// What a program takes, or a command of one. --help is always taken, --platform where `platformHelp` says
/// for what.
struct Usage {
    std::string call;     ///< "hexapose", "hexapose-cli inverse"
    QStringList operands; ///< the positional arguments, in the form of OptionSpec::value; all are required
    std::vector<OptionSpec> options;
    std::string about = {};  ///< above the list of the options
    std::string remark = {}; ///< below it
    std::string platformHelp = "Platform name or file (default: laboratory)."; ///< empty: no --platform
    QString furtherOperands = {}; ///< what any number of operands may follow: "[LOG.csv ...]"; empty: none

    /// What a complaint about the call as a whole begins with: "inverse".
    std::string subject() const { return call.substr(call.rfind(' ') + 1); }
    /// `options`, and those that are always taken.
    std::vector<OptionSpec> allOptions() const;
};

} // namespace hexapose
