// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/status/legs_panel.h"

#include "core/base/units.h"
#include "core/motion/limits.h"
#include "ui/common/read_out.h"
#include "ui/console/status/leg_bar.h"
#include "ui/console/status/settle_line.h"

#include <QEvent>
#include <QGridLayout>
#include <QVBoxLayout>

namespace hexapose {

namespace {
constexpr int kDecimals = 3;
}

LegsPanel::LegsPanel(const SharedModel& model, QWidget* parent)
    : Card(parent), m_model(model), m_settle(new SettleLine(model, this)) {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(3);
    for (std::size_t i = 0; i < m_heads.size(); ++i) {
        const bool number = i < 3;
        m_heads[i] = makeMutedLabel(this, (number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        m_heads[i]->setContentsMargins(0, 0, 3, 0); // as the read-outs below
        grid->addWidget(m_heads[i], 0, static_cast<int>(i) + 1);
    }
    for (int leg = 0; leg < kLegCount; ++leg) {
        addRow(*grid, leg);
    }
    grid->setColumnStretch(4, 1);
    body()->addLayout(grid);
    body()->addWidget(m_settle);
    retranslate();
}

void LegsPanel::addRow(QGridLayout& grid, int leg) {
    Row& row = m_rows[static_cast<std::size_t>(leg)];
    row = {new ReadOut(this), new ReadOut(this), new ReadOut(this), new LegBar(this)};
    const Leg& geometry = m_model->geometry().legs[static_cast<std::size_t>(leg)];
    row.bar->setStroke(geometry.minLength, geometry.maxLength);
    grid.addWidget(new QLabel(QStringLiteral("L%1").arg(leg + 1), this), leg + 1, 0);
    grid.addWidget(row.commanded, leg + 1, 1);
    grid.addWidget(row.measured, leg + 1, 2);
    grid.addWidget(row.error, leg + 1, 3);
    grid.addWidget(row.bar, leg + 1, 4);
}

void LegsPanel::showSnapshot(const Snapshot& snapshot) {
    m_settle->showSnapshot(snapshot);
    const MotionLimits limits = motionLimits(m_model->geometry(), snapshot.minLength, snapshot.maxLength);
    for (int i = 0; i < kLegCount; ++i) {
        const Row& row = m_rows[static_cast<std::size_t>(i)];
        const auto mm = [i](const std::optional<LegLengths>& lengths) {
            return lengths ? std::optional(mmFromMetres((*lengths)[i])) : std::nullopt;
        };
        const auto commanded = mm(snapshot.commandedLengths);
        const auto measured = mm(snapshot.measuredLengths);
        row.commanded->showNumber(commanded, kDecimals);
        row.measured->showNumber(measured, kDecimals);
        row.error->showNumber(commanded && measured ? std::optional(*measured - *commanded) : std::nullopt,
                              kDecimals);
        row.measured->setStale(snapshot.stale);
        row.error->setStale(snapshot.stale);
        row.bar->setStroke(mmFromMetres(limits.minLength[i]), mmFromMetres(limits.maxLength[i]));
        row.bar->setLengths(measured, commanded, snapshot.stale);
    }
}

void LegsPanel::retranslate() {
    setTitle(tr("Legs"));
    m_heads[0]->setText(tr("set-point, mm"));
    m_heads[1]->setText(tr("measured, mm"));
    m_heads[2]->setText(tr("error, mm"));
    m_heads[3]->setText(tr("within the stroke"));
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const QString leg = QString::number(i + 1);
        m_rows[i].commanded->setAccessibleName(tr("Leg %1 set-point").arg(leg));
        m_rows[i].measured->setAccessibleName(tr("Leg %1 measured").arg(leg));
        m_rows[i].error->setAccessibleName(tr("Leg %1 error").arg(leg));
        m_rows[i].bar->setAccessibleName(tr("Leg %1 within its stroke").arg(leg));
    }
}

void LegsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    Card::changeEvent(event);
}

} // namespace hexapose

#include "moc_legs_panel.cpp"
