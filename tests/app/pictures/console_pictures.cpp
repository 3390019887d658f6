// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Pictures of the real console, its virtual platform in mid-move: hexapose-pictures DIRECTORY

#include "app/console/console.h"
#include "core/base/units.h"
#include "core/geometry/geometry_file.h"
#include "ui/common/language.h"
#include "ui/console/motion/motion_panel.h"
#include "ui/console/motion/target_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>

#include <array>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

namespace hexapose {
namespace {

constexpr int kLookEveryMs = 10;
constexpr int kPatienceMs = 120000;
constexpr double kMidMove = 0.45; ///< of the last move is left when the picture is taken

Pose pose(double x, double y, double z, double alpha, double beta, double gamma) {
    PoseVector si(x, y, z, alpha, beta, gamma);
    si.head<3>() = si.head<3>().unaryExpr(&metresFromMm).eval();
    si.tail<3>() = si.tail<3>().unaryExpr(&radiansFromDeg).eval();
    return Pose::fromVector(si);
}

/// So that the charts have something to show, and every axis moves.
const std::array kTargets{pose(-14, 10, 22, 4, -6, 3), pose(20, -15, 8, -5, 3, -8),
                          pose(-22, -8, 26, 7, -4, 6), pose(16, 14, 12, -3, 6, -5),
                          pose(-8, 12, 30, 6, 5, -3),  pose(12, -4, 40, 0, 0, 5)};

struct Look {
    const char* file;
    const char* language;
    ThemeKind theme;
};
constexpr std::array kLooks{Look{"console.png", "en", ThemeKind::Light},
                            Look{"console-dark.png", "en", ThemeKind::Dark},
                            Look{"console-zh_CN.png", "zh_CN", ThemeKind::Light}};

/// Visits the targets as an operator would, and takes the picture while the platform moves to the last one.
class Visit {
public:
    Visit(OperatorWindow& window, const QString& file) : m_window(window), m_file(file) {
        QObject::connect(&m_timer, &QTimer::timeout, [this] { look(); });
        m_timer.start(kLookEveryMs);
    }

private:
    void look() {
        const Snapshot& now = m_window.latest();
        const bool rests = now.state == RunState::Unreferenced || now.state == RunState::Disabled ||
                           now.state == RunState::Enabled;
        if (m_moving && now.state == RunState::Enabled) {
            m_moving = false;
            ++m_next;
        }
        auto* run = m_window.findChild<QPushButton*>(QStringLiteral("run"));
        if (!m_pressed && rests && now.measuredPose && !now.stale && run->isEnabled()) {
            if (std::exchange(m_typed, m_next) == m_next) { // and its plan is there
                m_start = now.measuredPose->offset;
                m_pressed = true;
                run->click();
            } else {
                m_window.motionPanel().findChild<QComboBox*>()->setCurrentIndex(1); // workspace mode
                m_window.targetPanel().setTarget(kTargets[m_next]);
            }
        }
        if (now.state == RunState::Moving) {
            m_moving = true;
            m_pressed = false;
        }
        if (m_next + 1 == kTargets.size() && m_moving && now.measuredPose && isMidway(*now.measuredPose))
            take();
    }
    bool isMidway(const Pose& pose) const {
        const Eigen::Vector3d end = kTargets.back().offset;
        return (end - pose.offset).norm() < kMidMove * (end - m_start).norm();
    }
    void take() {
        m_timer.stop();
        const bool saved = m_window.grab().save(m_file);
        std::printf("%s%s\n", saved ? "" : "cannot write ", qPrintable(m_file));
        m_window.disconnectFrom();
        QCoreApplication::exit(saved ? 0 : 1);
    }

    OperatorWindow& m_window;
    QString m_file;
    QTimer m_timer;
    Eigen::Vector3d m_start = Eigen::Vector3d::Zero();
    std::size_t m_next = 0;
    std::optional<std::size_t> m_typed; ///< the target that stands in the fields
    bool m_pressed = false;
    bool m_moving = false;
};

int takePicture(QApplication& application, const Look& look, const QDir& folder, const QString& scratch) {
    ConsoleOptions options;
    options.geometry = loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
    options.connection = VirtualConnection{};
    options.language = QString::fromLatin1(look.language);
    options.theme = look.theme;
    options.method = "mpr3-nr";
    options.logDirectory = scratch.toStdString();
    Console console(application, options);
    console.window().resize(1280, 800);
    console.start();
    const Visit visit(console.window(), folder.filePath(QString::fromLatin1(look.file)));
    QTimer::singleShot(kPatienceMs, &console, [] { QCoreApplication::exit(1); });
    return QApplication::exec();
}

} // namespace
} // namespace hexapose

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: hexapose-pictures DIRECTORY\n", stderr);
        return 2;
    }
    const QTemporaryDir scratch; // neither settings nor logs of the person who runs this
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"})
        qputenv(name, scratch.path().toLocal8Bit());
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
        if (type == QtCriticalMsg || type == QtFatalMsg) { // the offscreen platform has much to say
            std::fprintf(stderr, "%s\n", qPrintable(text));
        }
    });
    QApplication application(argc, argv);
    QLocale::setDefault(QLocale::c());
    QCoreApplication::setOrganizationName(QStringLiteral("Hexapose"));
    QCoreApplication::setApplicationName(QStringLiteral("hexapose"));
    for (const auto& look : hexapose::kLooks)
        if (hexapose::takePicture(application, look, QDir(QString::fromLocal8Bit(argv[1])), scratch.path()) !=
            0) {
            std::fprintf(stderr, "hexapose-pictures: no %s\n", look.file);
            return 1;
        }
    return 0;
}
