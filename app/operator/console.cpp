// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/operator/console.h"

#include "app/common/device_factory.h"
#include "app/common/directories.h"
#include "app/operator/pose_book.h"
#include "core/device/serial/serial_ports.h"
#include "ui/panels/banner.h"
#include "ui/panels/event_list.h"
#include "ui/panels/named_poses.h"
#include "ui/panels/target_panel.h"
#include "ui/panels/window_menu.h"

#include <QApplication>
#include <QIcon>
#include <QSettings>

namespace hexapose {

namespace {

const QString kLanguageKey = QStringLiteral("language");
const QString kThemeKey = QStringLiteral("theme");

QStringList serialPortPaths() {
    QStringList paths;
    for (const SerialPortInfo& port : listSerialPorts()) {
        paths.append(QString::fromStdString(port.path));
    }
    return paths;
}

} // namespace

Console::Console(QApplication& application, const OperatorOptions& options, const PlatformGeometry& geometry)
    : m_application(application), m_options(options), m_geometry(geometry),
      m_model(geometry, options.method, cacheDirectory()) {
    QSettings settings;
    chooseLook(settings);
    m_window = std::make_unique<OperatorWindow>(geometry, serialPortPaths);
    m_window->setWindowIcon(QIcon(QStringLiteral(":/icons/hexapose.svg")));
    m_window->setColors(themeColors(m_theme));
    if (m_options.connection) {
        m_window->connectionPanel().setChoice(*m_options.connection);
    }
    auto* menu = new WindowMenu(*m_window, m_language.code(), m_theme);
    // What is chosen by hand is kept; what an option says is for this once.
    connect(menu, &WindowMenu::languageChosen, this, [this](const QString& code) {
        if (m_language.choose(code)) {
            QSettings().setValue(kLanguageKey, code);
        }
    });
    connect(menu, &WindowMenu::themeChosen, this, [this](ThemeKind kind) {
        m_theme = kind;
        applyTheme(m_application, kind);
        m_window->setColors(themeColors(kind));
        const std::string_view word = toWord(kind);
        QSettings().setValue(kThemeKey,
                             QString::fromLatin1(word.data(), static_cast<qsizetype>(word.size())));
    });
    NamedPoses& named = m_window->targetPanel().namedPoses();
    named.setPoses(loadNamedPoses(settings, geometry.fingerprint()));
    connect(&named, &NamedPoses::changed, this, [this, &named] {
        QSettings kept;
        saveNamedPoses(kept, m_geometry.fingerprint(), named.poses());
    });
    connect(&m_model, &ModelJob::progressed, this,
            [this](double part) { m_window->banner().showTraining(part); });
    connect(&m_model, &ModelJob::ready, this, &Console::openSession);
    connect(&m_model, &ModelJob::cancelled, this, [this] { useNewton({}); });
    connect(&m_model, &ModelJob::failed, this, &Console::useNewton);
    connect(&m_window->banner(), &Banner::cancelRequested, this, [this] { m_model.cancel(); });
}

Console::~Console() = default;

void Console::chooseLook(QSettings& settings) {
    QString language = m_options.language;
    if (language.isEmpty()) {
        language = languageFromText(settings.value(kLanguageKey).toString());
    }
    m_language.choose(language.isEmpty() ? desktopLanguage() : language);
    const auto remembered = themeFromWord(settings.value(kThemeKey).toString().toStdString());
    m_theme = m_options.theme.value_or(remembered.value_or(desktopTheme()));
    m_application.setFont(fontWithFallbacks(m_application.font()));
    applyTheme(m_application, m_theme);
}

void Console::start() {
    m_window->show();
    m_model.start();
}

void Console::openSession(const ReadySolver& solver) {
    m_window->banner().endTraining({});
    SessionSetup setup;
    setup.geometry = m_geometry;
    setup.solver = solver.solver;
    setup.modelFingerprint = solver.modelFingerprint;
    setup.programVersion = HEXAPOSE_VERSION;
    setup.logDirectory = m_options.logDirectory;
    const auto makeDevice = [geometry = m_geometry](const ConnectionChoice& choice) {
        return choice.virtualPlatform ? makeVirtualDevice(geometry)
                                      : makeSerialDevice(choice.port.toStdString(), choice.baud);
    };
    m_window->setSession(std::make_unique<Session>(setup, makeDevice));
    if (m_options.connection) {
        m_window->connectTo(*m_options.connection);
    }
}

void Console::useNewton(const QString& reason) {
    m_window->events().addNote(
        [reason] {
            const QString cause = reason.isEmpty() ? tr("The training of the model was cancelled")
                                                   : tr("The model could not be trained: %1").arg(reason);
            return EventText{cause, tr("Newton's method is used in its place."), Tone::Warn};
        },
        std::chrono::system_clock::now());
    openSession(m_model.withoutModel());
}

} // namespace hexapose
