// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/viewer_menu.h"

#include "ui/common/look_menu.h"
#include "ui/viewer/viewer_window.h"

#include <QAction>
#include <QEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

namespace hexapose {

ViewerMenu::ViewerMenu(ViewerWindow& window, LookMenu& look)
    : QObject(&window), m_window(window), m_look(look) {
    m_file = window.menuBar()->addMenu(QString());
    m_open = m_file->addAction(QString(), &window, [&window] { window.askForLogs(false); });
    m_open->setShortcut(QKeySequence::Open);
    m_openInLayout = m_file->addAction(QString(), &window, [&window] { window.askForLogs(true); });
    m_recent = m_file->addMenu(QString());
    m_file->addSeparator();
    m_export = m_file->addAction(QString(), &window, [&window] { window.askForExport(); });
    m_export->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_E));
    m_file->addSeparator();
    m_close = m_file->addAction(QString(), &window, [&window] { window.closeCurrent(); });
    m_close->setShortcut(QKeySequence::Close);
    m_quit = m_file->addAction(QString(), &window, &QWidget::close);
    m_quit->setShortcut(QKeySequence::Quit);

    m_charts = window.menuBar()->addMenu(QString());
    m_addChart = m_charts->addAction(QString(), &window, [&window] {
        if (LogPage* page = window.current())
            page->sheet().addChart({});
    });
    m_charts->addSeparator();
    m_saveLayout = m_charts->addAction(QString(), &window, &ViewerWindow::saveLayout);
    m_loadLayout = m_charts->addAction(QString(), &window, &ViewerWindow::loadLayoutFile);
    m_usualLayout = m_charts->addAction(QString(), &window, [&window] {
        if (LogPage* page = window.current())
            page->sheet().setChartLayout(defaultLayout(*page->sheet().table()));
    });

    m_view = window.menuBar()->addMenu(QString());
    look.addTo(*m_view);
    m_help = window.menuBar()->addMenu(QString());
    m_keys = m_help->addAction(QString(), this, &ViewerMenu::showKeys);
    window.installEventFilter(this);
    connect(&window, &ViewerWindow::currentChanged, this, &ViewerMenu::enable);
    showRecent({});
    enable();
    retranslate();
}

void ViewerMenu::showRecent(const QStringList& files) {
    m_recent->clear();
    for (const QString& file : files)
        m_recent->addAction(QFileInfo(file).fileName(), this, [this, file] { m_window.openLogs({file}); })
            ->setToolTip(file);
    m_recent->setToolTipsVisible(true);
    m_recent->setEnabled(!files.isEmpty());
}

void ViewerMenu::enable() {
    const bool any = m_window.current() != nullptr;
    for (QAction* action :
         {m_openInLayout, m_export, m_close, m_addChart, m_saveLayout, m_loadLayout, m_usualLayout})
        action->setEnabled(any);
}

void ViewerMenu::showKeys() {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("Keys"),
        tr("With the focus on a chart:\nleft and right: move through time\n+ and -: zoom\nHome: everything\n"
           "Backspace or Alt+left, Alt+right: views back and forward\nA and B: set a cursor at the pointer, "
           "or in "
           "the middle\nCtrl+left and Ctrl+right: the cursor set last, row by row\nEsc: no cursors\nMenu: "
           "curves "
           "and charts\n\nMouse: the wheel zooms in time, with Ctrl in values, with Shift it moves; a box "
           "zooms; "
           "Shift and drag moves; a click sets cursor A, with Ctrl cursor B."),
        QMessageBox::Close, &m_window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowModality(Qt::NonModal);
    box->show();
}

bool ViewerMenu::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    return QObject::eventFilter(watched, event);
}

void ViewerMenu::retranslate() {
    m_file->setTitle(tr("&File"));
    m_open->setText(tr("&Open log..."));
    m_openInLayout->setText(tr("Open another log in this &layout..."));
    m_recent->setTitle(tr("&Recent logs"));
    m_export->setText(tr("&Export..."));
    m_close->setText(tr("&Close log"));
    m_quit->setText(tr("&Quit"));
    m_charts->setTitle(tr("&Charts"));
    m_addChart->setText(tr("&Add chart"));
    m_saveLayout->setText(tr("&Save layout..."));
    m_loadLayout->setText(tr("&Load layout..."));
    m_usualLayout->setText(tr("&Usual charts"));
    m_view->setTitle(tr("&View"));
    m_help->setTitle(tr("&Help"));
    m_keys->setText(tr("&Keys..."));
}

} // namespace hexapose

#include "moc_viewer_menu.cpp"
