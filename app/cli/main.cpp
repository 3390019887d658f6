// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/common/arguments.h"
#include "app/describe/describe.h"
#include "core/base/input_error.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QtGlobal>

#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <string>

namespace {

using namespace hexapose;

struct Subcommand {
    const char* name;
    Usage (*usage)();
    int (*run)(const Arguments& arguments);
    bool draws; ///< needs fonts and a paint engine, but never a display
    const char* help;
};

constexpr Subcommand kSubcommands[] = {
    {"inverse", inverseUsage, inverseCommand, false, "leg lengths of poses"},
    {"forward", forwardUsage, forwardCommand, false, "poses of leg lengths"},
    {"train", trainUsage, trainCommand, false, "fit a regression model to a platform"},
    {"simulate", simulateUsage, simulateCommand, false, "a virtual platform on a pseudo-terminal"},
    {"run", runUsage, runCommand, true, "move a platform through a list of poses, and report"},
    {"report", reportUsage, reportCommand, true, "the error report of a recorded run"},
    {"summary", summaryUsage, summaryCommand, false,
     "count, extremes, mean and deviation of the columns of a log"},
    {"verify", verifyUsage, verifyCommand, false,
     "solve the recorded lengths of a log again, and list what differs"},
    {"compare", compareUsage, compareCommand, false, "how much the columns of two logs differ"},
    {"track", trackUsage, trackCommand, true,
     "the motion of a mechanism over a drive, by finite-step integration"},
    {"reproduce", reproduceUsage, reproduceCommand, true,
     "the published tables and figures beside measured values"},
    {"experiment", experimentUsage, experimentCommand, true,
     "closed loop: joint mode against workspace mode, simulated"},
};

void printHelp() {
    std::puts(
        "Usage: hexapose-cli COMMAND [OPTIONS]\n\nForward kinematics and control of six-legged parallel "
        "platforms.\n\nCommands:");
    for (const Subcommand& command : kSubcommands)
        std::printf("  %-10s %s\n", command.name, command.help);
    std::puts(
        "\n'hexapose-cli COMMAND --help' lists the options of a command. Exit status: 0 done; 1 the work ran "
        "but some\nrows or checks failed; 2 bad usage or input.");
}

const Subcommand* findSubcommand(const char* name) {
    for (const Subcommand& command : kSubcommands)
        if (std::strcmp(command.name, name) == 0)
            return &command;
    return nullptr;
}

/// Standard error is for the one line that a caller reads: Qt's own remarks are not for it.
void dropRemarks(QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (type == QtCriticalMsg || type == QtFatalMsg)
        std::fprintf(stderr, "hexapose-cli: %s\n", text.toLocal8Bit().constData());
}

ProgramDescription description() {
    ProgramDescription program{"hexapose-cli", {}, {}};
    for (const Subcommand& command : kSubcommands)
        program.commands.push_back({command.name, command.help, command.usage()});
    return program;
}

int runGuarded(const Subcommand& command, const QStringList& words) {
    try {
        const int status = command.run(Arguments(command.usage(), words));
        if (std::fflush(stdout) != 0 || std::ferror(stdout))
            throw InputError("standard output", std::strerror(errno));
        return status;
    } catch (const HelpRequest& help) {
        std::fputs(help.text.c_str(), stdout);
        return kExitDone;
    } catch (const InputError& error) {
        std::fprintf(stderr, "hexapose-cli: %s\n", error.what());
        return kExitBadInput;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "hexapose-cli: %s: %s\n", command.name, error.what());
        return kExitSomeFailed;
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2 || std::strcmp(argv[1], "--help") == 0 || std::strcmp(argv[1], "-h") == 0 ||
        std::strcmp(argv[1], "help") == 0) {
        if (argc >= 2) {
            printHelp();
            return kExitDone;
        }
        std::fputs("hexapose-cli: missing command (see hexapose-cli --help)\n", stderr);
        return kExitBadInput;
    }
    if (std::strcmp(argv[1], "--version") == 0) {
        std::puts("hexapose-cli " HEXAPOSE_VERSION);
        return kExitDone;
    }
    if (std::strcmp(argv[1], "--describe") == 0 && argc == 3)
        return printDescription(description(), argv[2]);
    const Subcommand* command = findSubcommand(argv[1]);
    if (!command) {
        std::fprintf(stderr, "hexapose-cli: unknown command '%s' (see hexapose-cli --help)\n", argv[1]);
        return kExitBadInput;
    }
    QStringList words;
    for (int i = 2; i < argc; ++i)
        words.append(QString::fromLocal8Bit(argv[i]));
    qInstallMessageHandler(dropRemarks);
    int ownCount = 1; // our options are not Qt's
    std::unique_ptr<QCoreApplication> application;
    if (command->draws) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        application = std::make_unique<QGuiApplication>(ownCount, argv);
    } else {
        application = std::make_unique<QCoreApplication>(ownCount, argv);
    }
    return runGuarded(*command, words);
}
