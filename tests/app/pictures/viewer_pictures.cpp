// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Pictures of the viewer with a log: hexapose-viewer-pictures LOG.csv DIRECTORY

#include "ui/common/language.h"
#include "ui/common/look_menu.h"
#include "ui/viewer/viewer_menu.h"
#include "ui/viewer/viewer_window.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QLocale>

#include <array>
#include <cstdio>

namespace hexapose {
namespace {

constexpr int kPatienceMs = 60000;
constexpr int kRestMs = 400; ///< after which the statistics are there

struct Look {
    const char* file;
    const char* language;
    ThemeKind theme;
    QSize size;
};
constexpr std::array kLooks{Look{"viewer.png", "en", ThemeKind::Light, {1280, 800}},
                            Look{"viewer-dark.png", "en", ThemeKind::Dark, {1280, 800}},
                            Look{"viewer-zh_CN.png", "zh_CN", ThemeKind::Light, {1280, 800}},
                            Look{"viewer-small.png", "en", ThemeKind::Light, {900, 600}}};

/// Handles events until the log has been read, and a little longer.
bool settle(ViewerWindow& window) {
    QElapsedTimer clock;
    clock.start();
    while (!window.current()->file().progress().isDone && clock.elapsed() < kPatienceMs)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    clock.restart();
    while (clock.elapsed() < kRestMs)
        QCoreApplication::processEvents(QEventLoop::AllEvents, kRestMs);
    return window.current()->file().progress().isDone;
}

bool takePicture(QApplication& application, const Look& look, const QString& log, const QDir& folder) {
    LanguageSwitch language;
    language.choose(QString::fromLatin1(look.language));
    application.setFont(fontWithFallbacks(application.font()));
    applyTheme(application, look.theme);
    ViewerWindow window;
    window.setColors(look.theme);
    LookMenu menu(language.code(), look.theme, &window);
    const ViewerMenu all(window, menu);
    window.openLogs({log});
    window.show();
    window.resize(look.size);
    if (!settle(window))
        return false;
    ChartSheet& sheet = window.current()->sheet();
    const TimeSpan whole = sheet.time();
    sheet.showTime({whole.begin + 0.2 * whole.length(), whole.begin + 0.7 * whole.length()});
    sheet.setCursors({whole.begin + 0.3 * whole.length(), whole.begin + 0.55 * whole.length()});
    settle(window);
    const QString file = folder.filePath(QString::fromLatin1(look.file));
    const bool isSaved = window.grab().save(file);
    std::printf("%s%s\n", isSaved ? "" : "cannot write ", qPrintable(file));
    return isSaved;
}

} // namespace
} // namespace hexapose

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("usage: hexapose-viewer-pictures LOG.csv DIRECTORY\n", stderr);
        return 2;
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
        if (type == QtCriticalMsg || type == QtFatalMsg) // the offscreen platform has much to say
            std::fprintf(stderr, "%s\n", qPrintable(text));
    });
    QApplication application(argc, argv);
    QLocale::setDefault(QLocale::c());
    bool isDone = true;
    for (const hexapose::Look& look : hexapose::kLooks)
        isDone = hexapose::takePicture(application, look, QString::fromLocal8Bit(argv[1]),
                                       QDir(QString::fromLocal8Bit(argv[2]))) &&
                 isDone;
    return isDone ? 0 : 1;
}
