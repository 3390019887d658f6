// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/card.h"
#include "ui/common/file_dialog.h"
#include "ui/common/labelled.h"
#include "ui/common/read_out.h"
#include "ui/console/report/report_panel.h"
#include "ui/console/report/report_preview.h"
#include "ui/console/report/sample_table.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

// How the report page is laid out and what it says; report_panel.cpp is what it does.
namespace hexapose {

namespace {
constexpr int kFileLines = 4;
constexpr int kTableHeight = 176; // header and six rows
} // namespace

void ReportPanel::build() {
    m_table = new QTableWidget(this);
    prepareSampleTable(*m_table);
    m_table->setFixedHeight(kTableHeight);
    m_preview = new ReportPreview(this);
    m_preview->setMinimumHeight(200);
    auto* page = new QVBoxLayout(this);
    page->setContentsMargins(0, 0, 0, 0);
    page->setSpacing(8);
    page->addWidget(buildTop());
    page->addWidget(m_preview, 1);
    page->addWidget(m_table);
    page->addWidget(buildFolderRow());
}

QWidget* ReportPanel::buildTop() {
    auto* top = new QWidget(this);
    m_listLabel = new QLabel(top);
    m_list = new QComboBox(top);
    m_listLabel->setBuddy(m_list); // on Linux a box is named by its label alone
    m_list->setMinimumContentsLength(24);
    m_list->addItem(QString());
    m_browseList = new QPushButton(top);
    m_run = new QPushButton(top);
    m_run->setProperty("kind", "primary");
    m_run->setObjectName(QStringLiteral("runReport"));
    m_clear = new QPushButton(top);
    m_clear->setEnabled(false);
    m_progress = new TextReadOut(1, top);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_listLabel, m_list, m_browseList, m_run, m_clear}) {
        row->addWidget(widget);
    }
    row->addStretch(1);
    auto* column = new QVBoxLayout(top);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(m_progress);
    connect(m_run, &QPushButton::clicked, this, &ReportPanel::runReport);
    connect(m_clear, &QPushButton::clicked, this, &ReportPanel::clearSamples);
    connect(m_browseList, &QPushButton::clicked, this, &ReportPanel::chooseList);
    connect(m_list, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (index == 0) {
            m_listFile.clear();
        }
    });
    return top;
}

QWidget* ReportPanel::buildFolderRow() {
    auto* foot = new QWidget(this);
    m_folderLabel = makeCaption(foot);
    m_folder = new QLineEdit(foot);
    m_browseFolder = new QPushButton(foot);
    m_filesLabel = makeCaption(foot);
    m_filesText = new TextReadOut(kFileLines, foot);
    auto* grid = new QGridLayout(foot);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(m_folderLabel, 0, 0);
    grid->addWidget(m_folder, 0, 1);
    grid->addWidget(m_browseFolder, 0, 2);
    grid->addWidget(m_filesLabel, 1, 0, Qt::AlignTop);
    grid->addWidget(m_filesText, 1, 1, 1, 2);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_filesLabel, m_filesText}) {
        widget->hide(); // until there are files
    }
    connect(m_folder, &QLineEdit::textEdited, this, [this] { m_folderChosen = true; });
    connect(m_browseFolder, &QPushButton::clicked, this, [this] {
        askForFile(*this, {tr("Folder of the report"), {}, folder(), QFileDialog::Directory},
                   [this](const QString& chosen) { setFolder(chosen); });
    });
    return foot;
}

void ReportPanel::retranslate() {
    m_listLabel->setText(tr("Poses"));
    m_list->setItemText(0, tr("10 at random, within 10 mm and 10\u00b0"));
    if (!m_listFile.isEmpty()) {
        const QString file = QFileInfo(m_listFile).fileName();
        m_list->count() < 2 ? m_list->addItem(file) : m_list->setItemText(1, file);
    }
    m_list->setAccessibleName(tr("List of poses"));
    label(*m_browseList, tr("From CSV..."), tr("Columns x_mm, y_mm, z_mm, alpha_deg, beta_deg, gamma_deg"));
    label(*m_run, tr("Run report"));
    updateRun();
    label(*m_clear, tr("Clear samples"), tr("Discard all samples"));
    m_table->setAccessibleName(tr("Samples"));
    nameSampleColumns(*m_table);
    fillSampleTable(*m_table, m_report);
    m_preview->setAccessibleName(tr("Preview of the report"));
    m_preview->setEmptyText(tr("No samples yet"));
    m_progress->setAccessibleName(tr("Report progress"));
    m_folderLabel->setText(tr("Folder"));
    m_folder->setAccessibleName(tr("Report folder"));
    label(*m_browseFolder, tr("Choose..."), tr("Choose the folder of the report"));
    m_browseFolder->setAccessibleName(tr("Choose report folder"));
    m_filesLabel->setText(tr("Files"));
    m_filesText->setAccessibleName(tr("Report files"));
    showProgress();
}

} // namespace hexapose
