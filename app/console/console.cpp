// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console.h"

#include "app/common/device_factory.h"
#include "app/common/directories.h"
#include "app/console/pose_book.h"
#include "core/device/serial/serial_ports.h"
#include "ui/common/solver_choices.h"
#include "ui/console/events/event_list.h"
#include "ui/console/motion/named_poses.h"
#include "ui/console/motion/target_panel.h"
#include "ui/console/status/banner.h"
#include "ui/console/window/window_menu.h"

#include <QApplication>
#include <QIcon>
#include <QSettings>

namespace hexapose {

namespace {

const QString kLanguageKey = QStringLiteral("language");
const QString kThemeKey = QStringLiteral("theme");
const QString kSolverKey = QStringLiteral("solver");

QStringList serialPortPaths() {
    QStringList paths;
    for (const SerialPortInfo& port : listSerialPorts()) {
        paths.append(QString::fromStdString(port.path));
    }
    return paths;
}

} // namespace

Console::Console(QApplication& application, const ConsoleOptions& options)
    : m_application(application), m_options(options), m_platform(makeModel(options.geometry)) {
    QSettings settings;
    chooseLook(settings);
    m_window = std::make_unique<OperatorWindow>(m_platform, serialPortPaths);
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
    loadPoses(named, settings);
    connect(&named, &NamedPoses::changed, this, [this, &named] {
        QSettings kept;
        saveNamedPoses(kept, m_platform->fingerprint(), named.poses());
    });
    connect(&m_window->banner(), &Banner::cancelRequested, this, [this] { m_model->cancel(); });
    if (m_options.method.empty()) {
        const std::string remembered = settings.value(kSolverKey).toString().toStdString();
        m_options.method = isSolverChoice(remembered) ? remembered : std::string(kSolverChoices.front());
    }
    // Queued: the box's list closes first, and gives the focus back to the box.
    connect(
        &m_window->connectionPanel(), &ConnectionPanel::solverChosen, this,
        [this](const QString& word) { makeSolver(word.toStdString()); }, Qt::QueuedConnection);
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

void Console::loadPoses(NamedPoses& named, QSettings& settings) {
    const LoadedPoses loaded = loadNamedPoses(settings, m_platform->fingerprint());
    named.setPoses(loaded.poses);
    if (loaded.dropped == 0) {
        return;
    }
    m_window->events().addNote(
        [dropped = loaded.dropped, all = loaded.dropped + static_cast<int>(loaded.poses.size())] {
            return EventText{tr("%1 of %2 named poses in the settings cannot be read and are left out")
                                 .arg(QString::number(dropped), QString::number(all)),
                             {},
                             Tone::Warn};
        },
        std::chrono::system_clock::now());
}

void Console::start() {
    m_window->show();
    m_window->connectionPanel().setSolver(m_options.method);
    makeSolver(m_options.method);
}

/// No other is chosen meanwhile, so that the job before this one is at its end.
void Console::makeSolver(const std::string& method) {
    m_window->connectionPanel().setSolverPending(true);
    m_model = std::make_unique<ModelJob>(m_platform, method, cacheDirectory());
    connect(m_model.get(), &ModelJob::progressed, this,
            [this](double part) { m_window->banner().showTraining(part); });
    connect(m_model.get(), &ModelJob::ready, this, &Console::useSolver);
    connect(m_model.get(), &ModelJob::cancelled, this, [this] { fallBackToNewton({}); });
    connect(m_model.get(), &ModelJob::failed, this, &Console::fallBackToNewton);
    m_model->start();
}

void Console::useSolver(const ReadySolver& solver) {
    m_window->banner().endTraining({});
    m_window->connectionPanel().setSolverPending(false);
    if (m_window->session() == nullptr) {
        openSession(solver);
        return;
    }
    m_window->setSolver(solver.solver, solver.modelFingerprint);
    const std::string_view word = solver.solver->name();
    QSettings().setValue(kSolverKey, QString::fromLatin1(word.data(), static_cast<qsizetype>(word.size())));
}

void Console::openSession(const ReadySolver& solver) {
    SessionSetup setup;
    setup.model = m_platform;
    setup.solver = solver.solver;
    setup.modelFingerprint = solver.modelFingerprint;
    setup.programVersion = HEXAPOSE_VERSION;
    setup.logDirectory = m_options.logDirectory;
    setup.control.envelope = m_options.envelope;
    setup.log = m_options.log;
    m_window->setSession(
        std::make_unique<Session>(setup, [platform = m_platform](const ConnectionSpec& connection) {
            return makeDevice(connection, platform->geometry());
        }));
    if (m_options.connection) {
        m_window->connectTo(*m_options.connection);
    }
    emit sessionReady();
}

/// At the start Newton's method serves in place of the model, later on what was there before.
void Console::fallBackToNewton(const QString& reason) {
    const bool first = m_window->session() == nullptr;
    m_window->events().addNote(
        [reason, first] {
            const QString cause = reason.isEmpty() ? tr("The training of the model was cancelled")
                                                   : tr("The model could not be trained: %1").arg(reason);
            return EventText{cause,
                             first ? tr("Newton's method is used in its place.")
                                   : tr("The solver stays as it was."),
                             Tone::Warn};
        },
        std::chrono::system_clock::now());
    if (first) {
        useSolver(m_model->withoutModel());
        return;
    }
    m_window->banner().endTraining({});
    m_window->connectionPanel().setSolverPending(false);
    m_window->connectionPanel().setSolver(m_window->session()->setup().solver->name());
}

} // namespace hexapose

#include "moc_console.cpp"
