// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/arguments.h"
#include "app/describe/describe.h"
#include "app/viewer/export_job.h"
#include "app/viewer/viewer.h"
#include "app/viewer/viewer_options.h"
#include "core/base/input_error.h"

#include <QApplication>
#include <QLocale>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace {

using namespace hexapose;

constexpr int kBadInput = 2;

int refuse(const char* message) {
    std::fprintf(stderr, "hexapose-viewer: %s\n", message);
    return kBadInput;
}

bool hasDisplay() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (const char* value = std::getenv(name); value != nullptr && *value != '\0')
            return true;
    return false;
}

/// Qt ends the program when a display is named that cannot be used; say it in one line and with our status.
void tellMessage(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
    if (type == QtFatalMsg) {
        std::fprintf(stderr, "hexapose-viewer: the display cannot be used; --export works without one\n");
        std::fflush(nullptr);
        _exit(kBadInput);
    }
    if (type == QtCriticalMsg)
        std::fprintf(stderr, "hexapose-viewer: %s\n", qPrintable(message));
}

int runViewer(const ViewerOptions& options) {
    // Our own options are not for Qt.
    static char name[] = "hexapose-viewer";
    static char* arguments[] = {name, nullptr};
    int count = 1;
    const bool isExport = !options.exportFile.empty();
    qInstallMessageHandler(tellMessage);
    QApplication application(count, arguments);
    if (!isExport)
        qInstallMessageHandler(nullptr);
    // Numbers are written with '.' in every language and on every desktop.
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    QCoreApplication::setOrganizationName(QStringLiteral("Hexapose"));
    QCoreApplication::setApplicationName(QStringLiteral("hexapose-viewer"));
    QCoreApplication::setApplicationVersion(QStringLiteral(HEXAPOSE_VERSION));
    QGuiApplication::setDesktopFileName(QStringLiteral("hexapose-viewer"));
    if (isExport) {
        LanguageSwitch language;
        language.choose(options.language.isEmpty() ? QStringLiteral("en") : options.language);
        return runExport(options);
    }
    Viewer viewer(application, options);
    viewer.start();
    return QApplication::exec();
}

} // namespace

int main(int argc, char* argv[]) {
    if (argc == 3 && std::strcmp(argv[1], "--describe") == 0) {
        Usage usage = viewerUsage();
        usage.operands = {QStringLiteral("LOG.csv...")};
        return printDescription({"hexapose-viewer", usage, {}}, argv[2]);
    }
    try {
        QStringList words;
        for (int i = 1; i < argc; ++i)
            words.append(QString::fromLocal8Bit(argv[i]));
        const ViewerOptions options = parseViewerOptions(words);
        if (options.version) {
            std::puts("hexapose-viewer " HEXAPOSE_VERSION);
            return 0;
        }
        if (!options.exportFile.empty())
            qputenv("QT_QPA_PLATFORM", "offscreen");
        else if (!hasDisplay())
            return refuse("there is no display; --export works without one");
        return runViewer(options);
    } catch (const HelpRequest& help) {
        std::fputs(help.text.c_str(), stdout);
        return 0;
    } catch (const InputError& error) {
        return refuse(error.what());
    }
}
