// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console_options.h"

#include "app/common/arguments.h"
#include "app/common/platform_check.h"
#include "core/base/input_error.h"
#include "ui/common/language.h"
#include "ui/common/solver_choices.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>
#include <vector>

namespace hexapose {

namespace {

std::vector<std::string> languageCodes() {
    std::vector<std::string> codes;
    for (const Language& language : languages()) {
        codes.push_back(language.code.toStdString());
    }
    return codes;
}

QString languageOf(const Arguments& arguments) {
    const QString code = languageFromText(QString::fromStdString(arguments.text("language", "")));
    if (code.isEmpty()) {
        arguments.choice("language", languageCodes(), ""); // names those that there are
    }
    return code;
}

std::optional<ConnectionSpec> connectionOf(const Arguments& arguments) {
    const int baud = arguments.baud();
    if (arguments.has("virtual") && arguments.has("port")) {
        throw InputError("--port", "cannot be used together with --virtual");
    }
    if (arguments.has("port")) {
        return SerialConnection{arguments.requiredText("port"), baud};
    }
    if (arguments.has("virtual") || arguments.has("headless")) {
        return VirtualConnection{};
    }
    return std::nullopt;
}

} // namespace

Usage consoleUsage() {
    return {
        "hexapose",
        {},
        {{"virtual", "", "Connect to the built-in virtual platform at once."},
         {"port", "PATH", "Connect to this serial port at once; one that is not there yet is waited for."},
         {"baud", "N", "Its baud rate (default: 115200)."},
         {"method",
          "M",
          "Forward method for this session: mpr3-nr, mpr2-nr, newton, or fsi, which follows the path of "
          "the legs in small steps (default: the one chosen last, at first mpr3-nr).",
          {kSolverChoices.begin(), kSolverChoices.end()}},
         {"envelope-mm", "E", "Refuse moves further than E mm from home along x, y or z."},
         {"envelope-deg", "E", "Refuse moves further than E degrees in alpha, beta or gamma."},
         {"log-dir", "DIR", "Where the logs go."},
         {"log-part-mb", "N", "Begin another file after N MB of a log (default: 1000)."},
         {"log-gzip", "", "Compress the files of a log but the last."},
         {"language", "CODE", "en or zh_CN (default: the desktop's).", languageCodes()},
         {"theme", "light|dark", "Look of the window (default: the desktop's)."},
         {"headless", "",
          "Without a display: run one move and a report of three poses, print the paths of log, "
          "report and picture."},
         {"output", "DIR", "Where --headless puts report and picture (default: beside the log)."},
         {"version", "", "Show the version."}},
        "The operator console of a six-legged parallel platform.",
        "Esc stops the motion wherever the focus is; Help, Keys lists the other keys."};
}

ConsoleOptions parseConsoleOptions(const QStringList& words) {
    const Arguments arguments(consoleUsage(), words);
    ConsoleOptions options;
    options.version = arguments.has("version");
    if (options.version) {
        return options;
    }
    options.connection = connectionOf(arguments);
    options.method = arguments.choice("method", {kSolverChoices.begin(), kSolverChoices.end()}, "");
    options.envelope = arguments.envelope();
    options.logDirectory = arguments.text("log-dir", "");
    options.log = arguments.logOptions();
    options.language = languageOf(arguments);
    options.theme = themeFromWord(arguments.choice("theme", {"light", "dark"}, ""));
    options.headless = arguments.has("headless");
    options.output = arguments.text("output", "");
    if (!options.output.empty() && !options.headless) {
        throw InputError("--output", "is for --headless only");
    }
    options.geometry = arguments.platform();
    if (options.headless)
        requireMovable(options.geometry, arguments.text("platform", "laboratory"));
    return options;
}

void requireWritable(const std::filesystem::path& directory, const std::string& option) {
    const std::string where = option + " " + directory.string();
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) {
        throw InputError(where, error.message());
    }
    if (!std::filesystem::is_directory(directory, error)) {
        throw InputError(where, "not a directory");
    }
    if (::access(directory.c_str(), W_OK | X_OK) != 0) {
        throw InputError(where, std::string("cannot be written: ") + std::strerror(errno));
    }
}

} // namespace hexapose
