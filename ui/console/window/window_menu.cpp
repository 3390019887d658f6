// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/window/window_menu.h"

#include "ui/common/look_menu.h"

#include <QAction>
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
    auto* look = new LookMenu(language, theme, this);
    look->addTo(*m_view);
    connect(look, &LookMenu::languageChosen, this, &WindowMenu::languageChosen);
    connect(look, &LookMenu::themeChosen, this, &WindowMenu::themeChosen);
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
    m_help->setTitle(tr("&Help"));
    m_keys->setText(tr("&Keys..."));
}

} // namespace hexapose

#include "moc_window_menu.cpp"
