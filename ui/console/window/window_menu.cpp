// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/window/window_menu.h"

#include "ui/common/language.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

namespace hexapose {

WindowMenu::WindowMenu(QMainWindow& window, const QString& language, ThemeKind theme)
    : QObject(&window), m_window(window) {
    m_file = window.menuBar()->addMenu(QString());
    m_quit = m_file->addAction(QString(), &window, &QWidget::close);
    m_quit->setShortcut(QKeySequence::Quit);
    m_view = window.menuBar()->addMenu(QString());
    m_languages = m_view->addMenu(QString());
    auto* languageGroup = new QActionGroup(this);
    for (const Language& one : languages()) {
        QAction* action = m_languages->addAction(one.name); // each language is named in itself
        action->setCheckable(true);
        action->setChecked(one.code == language);
        languageGroup->addAction(action);
        connect(action, &QAction::triggered, this, [this, code = one.code] { emit languageChosen(code); });
    }
    m_themes = m_view->addMenu(QString());
    auto* themeGroup = new QActionGroup(this);
    m_light = m_themes->addAction(QString());
    m_dark = m_themes->addAction(QString());
    for (QAction* action : {m_light, m_dark}) {
        action->setCheckable(true);
        themeGroup->addAction(action);
    }
    (theme == ThemeKind::Dark ? m_dark : m_light)->setChecked(true);
    connect(m_light, &QAction::triggered, this, [this] { emit themeChosen(ThemeKind::Light); });
    connect(m_dark, &QAction::triggered, this, [this] { emit themeChosen(ThemeKind::Dark); });
    m_help = window.menuBar()->addMenu(QString());
    m_keys = m_help->addAction(QString(), this, &WindowMenu::showKeys);
    window.installEventFilter(this);
    retranslate();
}

/// Beside the window and not before it: Stop stays within reach.
void WindowMenu::showKeys() {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("Keys"),
        tr("Esc: Stop, wherever the focus is.\n\nJog, with the focus on its buttons, for as long as the key "
           "is "
           "held:\nleft and right: x\ndown and up: y\npage down and page up: z\nwith Shift: alpha, beta, "
           "gamma\nspace: the button with the focus\n\nA second key, another window or a menu ends the "
           "motion."),
        QMessageBox::Close, &m_window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowModality(Qt::NonModal);
    box->show();
}

bool WindowMenu::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    return QObject::eventFilter(watched, event);
}

void WindowMenu::retranslate() {
    m_file->setTitle(tr("&File"));
    m_quit->setText(tr("&Quit"));
    m_view->setTitle(tr("&View"));
    m_languages->setTitle(tr("&Language"));
    m_themes->setTitle(tr("&Theme"));
    m_light->setText(tr("&Light"));
    m_dark->setText(tr("&Dark"));
    m_help->setTitle(tr("&Help"));
    m_keys->setText(tr("&Keys..."));
}

} // namespace hexapose

#include "moc_window_menu.cpp"
