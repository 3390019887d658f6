// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/status/pose_panel.h"

#include "core/kinematics/pose_accuracy.h"
#include "core/report/error_report.h"
#include "ui/common/read_out.h"
#include "ui/common/status_text.h"
#include "ui/console/status/singularity_bar.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace hexapose {

namespace {
constexpr int kQDecimals = 3;
} // namespace

PosePanel::PosePanel(SharedModel model, QWidget* parent) : Card(parent), m_model(std::move(model)) {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(3);
    for (std::size_t i = 0; i < m_heads.size(); ++i) {
        m_heads[i] = makeMutedLabel(this, Qt::AlignRight | Qt::AlignVCenter);
        m_heads[i]->setContentsMargins(0, 0, 3, 0); // as the read-outs below
        grid->addWidget(m_heads[i], 0, static_cast<int>(i) + 1);
    }
    for (int i = 0; i < 6; ++i) {
        addRow(*grid, i);
    }
    body()->addLayout(grid);
    addSingularity();
    retranslate();
}

void PosePanel::addRow(QGridLayout& grid, int coordinate) {
    Row& row = m_rows[static_cast<std::size_t>(coordinate)];
    row = {new ReadOut(this), new ReadOut(this), new ReadOut(this), new ReadOut(this)};
    const CoordinateText& text = coordinateTexts()[static_cast<std::size_t>(coordinate)];
    grid.addWidget(new QLabel(text.symbol, this), coordinate + 1, 0);
    grid.addWidget(row.path, coordinate + 1, 1);
    grid.addWidget(row.measured, coordinate + 1, 2);
    grid.addWidget(row.error, coordinate + 1, 3);
    row.expected->setDigits(7);
    grid.addWidget(row.expected, coordinate + 1, 4);
    auto* unit = makeMutedLabel(this);
    unit->setText(text.unit);
    grid.addWidget(unit, coordinate + 1, 5);
}

void PosePanel::addSingularity() {
    m_qLabel = makeCaption(this);
    m_qBar = new SingularityBar(this);
    m_q = new ReadOut(this);
    m_q->setDigits(6);
    m_q->setMaximumWidth(m_q->minimumWidth());
    auto* row = new QHBoxLayout;
    row->setSpacing(10);
    row->addWidget(m_qLabel);
    row->addWidget(m_qBar, 1);
    row->addWidget(m_q);
    body()->addLayout(row);
}

void PosePanel::showSnapshot(const Snapshot& snapshot) {
    const std::optional<Pose>& at = snapshot.measuredPose;
    const auto rounding =
        at ? std::optional(roundingEffect(m_model->geometry(), *at, kLengthResolution)) : std::nullopt;
    for (int i = 0; i < 6; ++i) {
        const Row& row = m_rows[static_cast<std::size_t>(i)];
        const int decimals = coordinateTexts()[static_cast<std::size_t>(i)].angle ? 4 : 3;
        const auto shown = [i](const std::optional<Pose>& pose) {
            return pose ? std::optional(toDisplay(i, pose->toVector()[i])) : std::nullopt;
        };
        std::optional<double> error;
        if (snapshot.measuredPose && snapshot.targetPose) {
            error = displayError(i, snapshot.measuredPose->toVector()[i], snapshot.targetPose->toVector()[i]);
        }
        row.path->showNumber(shown(snapshot.targetPose), decimals);
        row.measured->showNumber(shown(snapshot.measuredPose), decimals);
        row.error->showNumber(error, decimals);
        row.expected->showNumber(rounding ? std::optional(toDisplay(i, rounding->bound[i])) : std::nullopt,
                                 decimals); // a dash where it is infinite
        for (ReadOut* readOut : {row.measured, row.error, row.expected}) {
            readOut->setStale(snapshot.stale);
        }
    }
    const std::optional<double> q = snapshot.measuredPose ? snapshot.determinantRatio : std::nullopt;
    m_qBar->setValue(q, snapshot.stale);
    m_q->showNumber(q, kQDecimals);
    m_q->setStale(snapshot.stale);
    const Tone tone = toneOfQ(q);
    setTone(*m_q, snapshot.stale || tone == Tone::Good ? Tone::Idle : tone);
}

void PosePanel::retranslate() {
    setTitle(tr("Pose"));
    m_heads[0]->setText(tr("path"));
    m_heads[1]->setText(tr("measured"));
    m_heads[2]->setText(tr("error"));
    m_heads[3]->setText(QString::fromUtf8("\u00b1 ") + tr("expected"));
    m_heads[3]->setToolTip(tr("The largest error that the 0.1 mm resolution of the lengths explains"));
    setCaption(*m_qLabel, tr("Singularity margin q"));
    m_q->setAccessibleName(tr("Singularity margin q"));
    m_qBar->setAccessibleName(tr("Singularity margin bar"));
    const QString tip = tr("Distance from a singular pose: 1 at home, 0 where the platform cannot be held. "
                           "Amber below 0.2, red below 0.05.");
    m_qBar->setToolTip(tip);
    m_q->setToolTip(tip);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const QString word = coordinateTexts()[i].word;
        m_rows[i].path->setAccessibleName(tr("Path %1").arg(word));
        m_rows[i].measured->setAccessibleName(tr("Measured %1").arg(word));
        m_rows[i].error->setAccessibleName(tr("Error %1").arg(word));
        m_rows[i].expected->setAccessibleName(tr("Expected error %1").arg(word));
    }
}

void PosePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    Card::changeEvent(event);
}

} // namespace hexapose

#include "moc_pose_panel.cpp"
