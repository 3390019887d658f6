// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart_page.h"
#include "ui/common/labelled.h"
#include "ui/console/events/event_list.h"
#include "ui/console/motion/motion_panel.h"
#include "ui/console/report/report_panel.h"
#include "ui/console/status/banner.h"
#include "ui/console/status/legs_panel.h"
#include "ui/console/status/pose_panel.h"
#include "ui/console/status/status_panel.h"
#include "ui/console/window/operator_window.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>

// How the window is laid out; operator_window.cpp is what it does.
namespace hexapose {

namespace {
constexpr int kLeftWidth = 336;
constexpr int kSpacing = 8;
} // namespace

void OperatorWindow::build() {
    m_pages = new QStackedWidget(this);
    m_pages->addWidget(buildConsole());
    m_pages->addWidget(m_report);

    // What moves the platform, Stop and the events stand beside every page.
    auto* left = new QVBoxLayout;
    left->setSpacing(kSpacing);
    m_motion->setFixedWidth(kLeftWidth);
    m_events->setFixedWidth(kLeftWidth);
    left->addWidget(m_motion);
    left->addWidget(m_events, 1);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(kSpacing);
    middle->addLayout(left);
    middle->addWidget(m_pages, 1);

    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(10, 8, 10, 0);
    column->setSpacing(kSpacing);
    column->addWidget(buildHeader());
    column->addWidget(m_banner);
    column->addLayout(middle, 1);
    column->addWidget(m_status);
    setCentralWidget(centre);
    resize(1280, 800);
}

QWidget* OperatorWindow::buildHeader() {
    auto* header = new QFrame(this);
    header->setObjectName(QStringLiteral("header"));
    m_pageGroup = new QButtonGroup(this);
    m_consolePage = new QPushButton(header);
    m_reportPage = new QPushButton(header);
    int id = 0;
    for (QPushButton* button : {m_consolePage, m_reportPage}) {
        button->setCheckable(true);
        m_pageGroup->addButton(button, id++);
    }
    m_consolePage->setChecked(true);
    m_export = new QPushButton(header);
    m_export->setObjectName(QStringLiteral("exportReport"));
    auto* row = new QHBoxLayout(header);
    row->setContentsMargins(12, 6, 12, 6);
    row->setSpacing(6);
    row->addWidget(m_connection);
    row->addStretch(1);
    for (QPushButton* button : {m_consolePage, m_reportPage, m_export}) {
        row->addWidget(button);
    }
    return header;
}

QWidget* OperatorWindow::buildConsole() {
    auto* page = new QWidget(this);
    auto* numbers = new QHBoxLayout;
    numbers->setSpacing(kSpacing);
    numbers->addWidget(m_legs, 1);
    numbers->addWidget(m_pose, 0);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpacing);
    column->addWidget(m_charts, 1);
    column->addLayout(numbers);
    return page;
}

void OperatorWindow::retranslate() {
    setWindowTitle(tr("Hexapose"));
    label(*m_consolePage, tr("Console"), tr("Charts, legs and pose"));
    label(*m_reportPage, tr("Report"), tr("The error report and its samples"));
    label(*m_export, tr("Export report"), tr("Write report.pdf, errors.csv, errors.png and errors.svg"));
}

void OperatorWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QMainWindow::changeEvent(event);
}

} // namespace hexapose
