// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/directories.h"
#include "app/common/platform_check.h"
#include "app/common/port_check.h"
#include "app/console/console.h"
#include "app/console/console_options.h"
#include "app/console/end_signals.h"
#include "app/console/headless_job.h"
#include "core/base/input_error.h"
#include "core/geometry/geometry_file.h"

#include <QApplication>
#include <QLocale>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace {

using namespace hexapose;

constexpr int kBadInput = 2;

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
void tellMessage(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
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

int runConsole(const ConsoleOptions& options, const PlatformGeometry& geometry) {
    // Our own options are not for Qt: it would take --platform for one of its own.
    static char name[] = "hexapose";
    static char* arguments[] = {name, nullptr};
    int count = 1;
    EndSignals endSignals; // before Qt starts a thread
    qInstallMessageHandler(tellMessage);
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

    Console console(application, options, geometry);
    HeadlessJob job(console.window(), options.output);
    // As by Disconnect: stop, disable, close the log; then the program ends.
    QObject::connect(&endSignals, &EndSignals::received, &application, [&] {
        if (options.headless) {
            job.interrupt();
        } else {
            console.window().disconnectFrom();
            QCoreApplication::exit(0);
        }
    });
    endSignals.watch();
    console.start();
    if (options.headless) {
        QObject::connect(&job, &HeadlessJob::finished, &application, &QCoreApplication::exit,
                         Qt::QueuedConnection);
        job.start();
    }
    return QApplication::exec();
}

} // namespace

int main(int argc, char* argv[]) {
    try {
        ConsoleOptions options = parseOperatorOptions({argv + 1, argv + argc});
        if (options.help) {
            std::fputs(operatorHelp().c_str(), stdout);
            return 0;
        }
        if (options.version) {
            std::puts("hexapose " HEXAPOSE_VERSION);
            return 0;
        }
        const PlatformGeometry geometry = loadPlatform(findPlatformFile(options.platform));
        if (options.headless) {
            requireMovable(geometry, options.platform);
        }
        if (options.connection && !options.connection->virtualPlatform) {
            requireSerialPort(options.connection->port.toStdString());
        }
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
        return runConsole(options, geometry);
    } catch (const InputError& error) {
        return refuse(error.what());
    }
}
