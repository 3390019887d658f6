// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/file_dialog.h"
#include "ui/common/labelled.h"
#include "ui/common/read_out.h"
#include "ui/console/motion/way_point_table.h"
#include "ui/console/motion/way_points_panel.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

// How the way-points look and what they say; way_points_panel.cpp is what they do.
namespace hexapose {

namespace {
constexpr int kMessageLines = 3;
constexpr int kLeastTableHeight = 90;
} // namespace

QPushButton* WayPointsPanel::addButton(QHBoxLayout& row, int stretch) {
    auto* button = new QPushButton(this);
    button->setProperty("compact", true);
    row.addWidget(button, stretch);
    return button;
}

void WayPointsPanel::build() {
    m_table = new WayPointTable(this);
    m_table->setMinimumHeight(kLeastTableHeight);
    m_message = new TextReadOut(kMessageLines, this);
    const auto makeRow = [] {
        auto* row = new QHBoxLayout;
        row->setSpacing(5);
        return row;
    };
    QHBoxLayout* adding = makeRow();
    m_addMeasured = addButton(*adding);
    m_addTarget = addButton(*adding);
    m_load = addButton(*adding, 0);
    m_save = addButton(*adding, 0);
    QHBoxLayout* ordering = makeRow();
    m_play = addButton(*ordering);
    m_play->setProperty("kind", "primary");
    m_pause = addButton(*ordering);
    m_pause->setCheckable(true);
    m_step = addButton(*ordering);
    m_remove = addButton(*ordering, 0);
    m_up = addButton(*ordering, 0);
    m_down = addButton(*ordering, 0);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(m_table, 1);
    column->addLayout(adding);
    column->addLayout(ordering);
    column->addWidget(m_message);

    connect(m_table, &WayPointTable::edited, this, &WayPointsPanel::followTable);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &WayPointsPanel::updateButtons);
    connect(m_addMeasured, &QPushButton::clicked, this,
            [this] { addPose(m_from ? std::optional(m_from->pose) : std::nullopt); });
    connect(m_addTarget, &QPushButton::clicked, this,
            [this] { addPose(m_target ? m_target() : std::nullopt); });
    connect(m_remove, &QPushButton::clicked, m_table, &WayPointTable::removeCurrent);
    connect(m_up, &QPushButton::clicked, this, [this] { m_table->moveCurrent(-1); });
    connect(m_down, &QPushButton::clicked, this, [this] { m_table->moveCurrent(1); });
    connect(m_load, &QPushButton::clicked, this, [this] { chooseFile(false); });
    connect(m_save, &QPushButton::clicked, this, [this] { chooseFile(true); });
    connect(m_play, &QPushButton::clicked, this, &WayPointsPanel::play);
    connect(m_step, &QPushButton::clicked, this, &WayPointsPanel::step);
    connect(m_pause, &QPushButton::toggled, this, &WayPointsPanel::setPaused);
}

void WayPointsPanel::chooseFile(bool toSave) {
    const QString filter = tr("Poses (*.csv);;All files (*)");
    if (toSave) {
        askForFile(*this,
                   {tr("Save the way-points"),
                    filter,
                    {},
                    QFileDialog::AnyFile,
                    QFileDialog::AcceptSave,
                    QStringLiteral("csv")},
                   [this](const QString& file) { save(file); });
    } else {
        askForFile(*this, {tr("Load way-points"), filter}, [this](const QString& file) { load(file); });
    }
}

void WayPointsPanel::retranslate() {
    m_table->setAccessibleName(tr("Way-points"));
    m_table->setToolTip(tr("x y z in mm, alpha beta gamma in degrees; a double click edits"));
    label(*m_addMeasured, tr("+ Measured"), tr("Add measured"), tr("Add the measured pose; nothing moves"));
    label(*m_addTarget, tr("+ Target"), tr("Add target"), {});
    label(*m_load, tr("Load..."), tr("Load way-points"),
          tr("From CSV: columns x_mm, y_mm, z_mm, alpha_deg, beta_deg, gamma_deg"));
    label(*m_save, tr("Save..."), tr("Save way-points"), tr("As CSV with the same columns"));
    label(*m_play, tr("Play"), tr("Play"), tr("Visit them all, from the first; the platform moves"));
    label(*m_pause, tr("Pause"), tr("Pause motion"), tr("Hold the motion on its path; press again to go on"));
    label(*m_step, tr("Step"), tr("Step"), tr("Go to the next one only; the platform moves"));
    label(*m_remove, QString::fromUtf8("\u2212"), tr("Remove way-point"), tr("Remove the chosen row"));
    label(*m_up, QString::fromUtf8("\u2191"), tr("Move up"), tr("Move the chosen row up"));
    label(*m_down, QString::fromUtf8("\u2193"), tr("Move down"), tr("Move the chosen row down"));
    m_message->setAccessibleName(tr("Way-point progress"));
    followTable();
}

} // namespace hexapose
