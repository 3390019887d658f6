// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/column_list.h"
#include "ui/viewer/cursor_table.h"
#include "ui/viewer/log_summary.h"
#include "ui/viewer/problem_panel.h"
#include "ui/viewer/view_bar.h"
#include "ui/viewer/viewer_window.h"

#include <QEvent>
#include <QLabel>
#include <QScreen>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

// How the window is laid out; viewer_window.cpp is what it does.
namespace hexapose {

namespace {

constexpr int kSideWidth = 232;
constexpr int kSpacing = 8;
constexpr QSize kUsualSize(1280, 800);

} // namespace

void ViewerWindow::build() {
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setProperty("muted", true);
    m_pages->addWidget(m_hint);
    m_tabs->setTabsClosable(true);
    m_tabs->setExpanding(false);
    m_tabs->setDrawBase(false);

    auto* charts = new QSplitter(Qt::Vertical, this);
    charts->setChildrenCollapsible(false);
    charts->addWidget(m_pages);
    charts->addWidget(m_cursorTable);
    charts->setStretchFactor(0, 4);
    charts->setStretchFactor(1, 1);
    charts->setSizes({560, 150});
    m_pages->setMinimumHeight(150);
    m_cursorTable->setMinimumHeight(70);

    auto* right = new QVBoxLayout;
    right->setSpacing(kSpacing / 2);
    right->addWidget(m_tabs);
    right->addWidget(charts, 1);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(kSpacing);
    middle->addWidget(buildSide());
    middle->addLayout(right, 1);

    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(10, 8, 10, 8);
    column->setSpacing(kSpacing);
    column->addWidget(m_bar);
    column->addLayout(middle, 1);
    setCentralWidget(centre);
    resize(kUsualSize.boundedTo(screen()->availableSize()));
}

QWidget* ViewerWindow::buildSide() {
    auto* side = new QWidget(this);
    side->setFixedWidth(kSideWidth);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpacing);
    column->addWidget(m_summary);
    column->addWidget(m_columns, 3);
    column->addWidget(m_problems, 2);
    return side;
}

void ViewerWindow::retranslate() {
    const LogPage* page = current();
    const QString program = tr("Hexapose viewer");
    setWindowTitle(page == nullptr
                       ? program
                       : m_tabs->tabText(m_tabs->currentIndex()) + QStringLiteral(" - ") + program);
    m_tabs->setAccessibleName(tr("Open logs"));
    m_hint->setText(tr("Open a log (Ctrl+O), or drop a file here"));
}

void ViewerWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QMainWindow::changeEvent(event);
}

} // namespace hexapose
