// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewer/viewer.h"

#include "ui/common/look_menu.h"
#include "ui/viewer/viewer_menu.h"

#include <QApplication>
#include <QFile>
#include <QIcon>
#include <QSettings>

namespace hexapose {

namespace {

const QString kLanguageKey = QStringLiteral("language");
const QString kThemeKey = QStringLiteral("theme");
const QString kRecentKey = QStringLiteral("recentLogs");
constexpr int kRecentLogs = 10;

} // namespace

Viewer::Viewer(QApplication& application, const ViewerOptions& options)
    : m_application(application), m_options(options) {
    QSettings settings;
    chooseLook(settings);
    m_window = std::make_unique<ViewerWindow>();
    m_window->setWindowIcon(QIcon(QStringLiteral(":/icons/hexapose.svg")));
    m_window->setColors(m_theme);
    auto* look = new LookMenu(m_language.code(), m_theme, m_window.get());
    m_menu = new ViewerMenu(*m_window, *look);
    m_menu->showRecent(settings.value(kRecentKey).toStringList());
    // What is chosen by hand is kept; what an option says is for this once.
    connect(look, &LookMenu::languageChosen, this, [this](const QString& code) {
        if (m_language.choose(code))
            QSettings().setValue(kLanguageKey, code);
    });
    connect(look, &LookMenu::themeChosen, this, [this](ThemeKind kind) {
        m_theme = kind;
        applyTheme(m_application, kind);
        m_window->setColors(kind);
        const std::string_view word = toWord(kind);
        QSettings().setValue(kThemeKey,
                             QString::fromLatin1(word.data(), static_cast<qsizetype>(word.size())));
    });
    connect(m_window.get(), &ViewerWindow::logOpened, this, &Viewer::remember);
}

Viewer::~Viewer() = default;

void Viewer::chooseLook(QSettings& settings) {
    QString language = m_options.language;
    if (language.isEmpty())
        language = languageFromText(settings.value(kLanguageKey).toString());
    m_language.choose(language.isEmpty() ? desktopLanguage() : language);
    const auto remembered = themeFromWord(settings.value(kThemeKey).toString().toStdString());
    m_theme = m_options.theme.value_or(remembered.value_or(desktopTheme()));
    m_application.setFont(fontWithFallbacks(m_application.font()));
    applyTheme(m_application, m_theme);
}

void Viewer::start() {
    std::optional<ChartLayout> layout;
    if (!m_options.layout.empty())
        layout = loadLayout(QFile::decodeName(m_options.layout.c_str()));
    QStringList logs;
    for (const std::filesystem::path& log : m_options.logs)
        logs.append(QFile::decodeName(log.c_str()));
    m_window->openLogs(logs, {layout, m_options.charts, m_options.from, m_options.to});
    m_window->show();
}

void Viewer::remember(const QString& log) {
    QSettings settings;
    QStringList recent = settings.value(kRecentKey).toStringList();
    recent.removeAll(log);
    recent.prepend(log);
    recent = recent.mid(0, kRecentLogs);
    settings.setValue(kRecentKey, recent);
    m_menu->showRecent(recent);
}

} // namespace hexapose

#include "moc_viewer.cpp"
