// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/arguments.h"
#include "app/common/directories.h"
#include "app/common/port_check.h"
#include "app/console/console.h"
#include "app/console/console_options.h"
#include "app/console/end_signals.h"
#include "app/console/exit_guard.h"
#include "app/console/headless_job.h"
#include "app/describe/describe.h"
#include "core/base/input_error.h"
#include "core/session/trial_poses.h"

#include <QApplication>
#include <QLocale>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <unistd.h>
#include <vector>

namespace {

using namespace hexapose;

constexpr int kBadInput = 2;
constexpr int kReportPoses = 3; ///< enough to show the report without a long wait

int refuse(const char* message) {
    std::fprintf(stderr, "hexapose: %s\n", message);
    return kBadInput;
}

bool hasDisplay() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        if (const char* value = std::getenv(name); value != nullptr && *value != '\0') {
            return true;
        }
    }
    return false;
}

/// Qt ends the program when a display is named that cannot be used; say it in one line and with our status.
void reportQtMessage(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
    if (type == QtFatalMsg) {
        std::fprintf(stderr, "hexapose: the display cannot be used; --headless works without one\n");
        std::fflush(nullptr);
        _exit(kBadInput);
    }
    // The search for a display and the offscreen platform talk a lot; what they say helps no operator.
    if (type == QtCriticalMsg) {
        std::fprintf(stderr, "hexapose: %s\n", qPrintable(message));
    }
}

/// A port that is not there is waited for, as when the window is asked for it; without a window nobody would
/// see that.
void checkPort(const ConsoleOptions& options) {
    const auto* serial = options.connection ? std::get_if<SerialConnection>(&*options.connection) : nullptr;
    if (serial == nullptr) {
        return;
    }
    if (options.headless) {
        requireSerialPort(serial->path);
    } else {
        refuseOtherThanPort(serial->path);
    }
}

/// trial: what a headless run visits; empty for a window.
int runConsole(const ConsoleOptions& options, const std::vector<Pose>& trial) {
    // Our own options are not for Qt: it would take --platform for one of its own.
    static char name[] = "hexapose";
    static char* arguments[] = {name, nullptr};
    int count = 1;
    EndSignals endSignals; // before Qt starts a thread
    qInstallMessageHandler(reportQtMessage);
    QApplication application(count, arguments);
    if (!options.headless) {
        qInstallMessageHandler(nullptr);
    }
    // Numbers are written with '.' in every language and on every desktop.
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    QCoreApplication::setOrganizationName(QStringLiteral("Hexapose"));
    QCoreApplication::setApplicationName(QStringLiteral("hexapose"));
    QCoreApplication::setApplicationVersion(QStringLiteral(HEXAPOSE_VERSION));
    QGuiApplication::setDesktopFileName(QStringLiteral("hexapose"));

    Console console(application, options);
    const ExitGuard guard([&console] {
        if (Session* session = console.window().session()) {
            session->close(); // and leave the window, which may have no display
        }
    });
    std::unique_ptr<HeadlessJob> job;
    if (options.headless) {
        job = std::make_unique<HeadlessJob>(
            trial, HeadlessJob::Output{options.output, [&console] { return console.window().grab(); }});
        QObject::connect(&console, &Console::sessionReady, job.get(), [&] {
            Session& session = *console.window().session();
            session.isOpen() ? job->start(session) : job->fail("the log cannot be created");
        });
        QObject::connect(job.get(), &HeadlessJob::over, &console.window(), &OperatorWindow::disconnectFrom);
        QObject::connect(job.get(), &HeadlessJob::finished, &application, &QCoreApplication::exit,
                         Qt::QueuedConnection);
    }
    // As by Disconnect: stop, disable, close the log; then the program ends.
    QObject::connect(&endSignals, &EndSignals::received, &application, [&] {
        if (job) {
            job->interrupt();
        } else {
            console.window().disconnectFrom();
            QCoreApplication::exit(0);
        }
    });
    endSignals.watch();
    console.start();
    return QApplication::exec();
}

} // namespace

int main(int argc, char* argv[]) {
    if (argc == 3 && std::strcmp(argv[1], "--describe") == 0) {
        return printDescription({"hexapose", consoleUsage(), {}}, argv[2]);
    }
    try {
        QStringList words;
        for (int i = 1; i < argc; ++i) {
            words.append(QString::fromLocal8Bit(argv[i]));
        }
        ConsoleOptions options = parseConsoleOptions(words);
        if (options.version) {
            std::puts("hexapose " HEXAPOSE_VERSION);
            return 0;
        }
        checkPort(options);
        const std::vector<Pose> trial =
            options.headless ? trialPoses(*makeModel(options.geometry), options.envelope, kReportPoses)
                             : std::vector<Pose>();
        if (options.logDirectory.empty()) {
            options.logDirectory = defaultLogDirectory();
        }
        requireWritable(options.logDirectory, "--log-dir");
        if (!options.output.empty()) {
            requireWritable(options.output, "--output");
        }
        if (options.headless) {
            qputenv("QT_QPA_PLATFORM", "offscreen");
        } else if (!hasDisplay()) {
            return refuse("there is no display; --headless works without one");
        }
        return runConsole(options, trial);
    } catch (const HelpRequest& help) {
        std::fputs(help.text.c_str(), stdout);
        return 0;
    } catch (const InputError& error) {
        return refuse(error.what());
    }
}
