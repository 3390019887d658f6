// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/units.h"
#include "ui/common/card.h"
#include "ui/common/labelled.h"
#include "ui/common/read_out.h"
#include "ui/common/status_text.h"
#include "ui/console/motion/guided_test_panel.h"

#include <QGridLayout>
#include <QPushButton>

// How the guided test looks and what it says; guided_test_panel.cpp is what it does.
namespace hexapose {

namespace {
constexpr int kResultDecimals = 3;
constexpr int kResultDigits = 6;
} // namespace

void GuidedTestPanel::buildSteps(QVBoxLayout& column) {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(2);
    for (int i = 0; i < kSteps; ++i) {
        const auto at = static_cast<std::size_t>(i);
        m_lamps[at] = makeLamp(this);
        m_stepTexts[at] = new QLabel(this);
        grid->addWidget(m_lamps[at], i, 0);
        grid->addWidget(m_stepTexts[at], i, 1);
    }
    grid->setColumnStretch(1, 1);
    column.addLayout(grid);
}

void GuidedTestPanel::buildResult(QVBoxLayout& column) {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(1);
    for (std::size_t i = 0; i < m_heads.size(); ++i) {
        m_heads[i] = makeMutedLabel(this, Qt::AlignRight | Qt::AlignVCenter);
        m_heads[i]->setContentsMargins(0, 0, 3, 0); // as the read-outs below
        grid->addWidget(m_heads[i], 0, static_cast<int>(i) + 1);
    }
    for (int i = 0; i < 6; ++i) {
        addRow(*grid, i);
    }
    column.addLayout(grid);
    m_lengthsTitle = makeMutedLabel(this);
    column.addWidget(m_lengthsTitle);
    auto* lengths = new QGridLayout;
    lengths->setHorizontalSpacing(6);
    lengths->setVerticalSpacing(1);
    for (int leg = 0; leg < 6; ++leg) {
        auto* readOut = new ReadOut(this);
        readOut->setDigits(7);
        m_lengths[static_cast<std::size_t>(leg)] = readOut;
        QLabel* label = makeMutedLabel(this);
        label->setText(QStringLiteral("L%1").arg(leg + 1));
        lengths->addWidget(label, leg / 3, 2 * (leg % 3));
        lengths->addWidget(readOut, leg / 3, 2 * (leg % 3) + 1);
        lengths->setColumnStretch(2 * (leg % 3) + 1, 1);
    }
    column.addLayout(lengths);
}

void GuidedTestPanel::addRow(QGridLayout& grid, int coordinate) {
    Row& row = m_rows[static_cast<std::size_t>(coordinate)];
    row = {new ReadOut(this), new ReadOut(this), new ReadOut(this), new ReadOut(this)};
    const CoordinateText& text = coordinateTexts()[static_cast<std::size_t>(coordinate)];
    grid.addWidget(new QLabel(text.symbol, this), coordinate + 1, 0);
    int column = 1;
    for (ReadOut* readOut : {row.target, row.measured, row.error, row.expected}) {
        readOut->setDigits(kResultDigits);
        grid.addWidget(readOut, coordinate + 1, column++);
    }
    QLabel* unit = makeMutedLabel(this);
    unit->setText(text.unit);
    grid.addWidget(unit, coordinate + 1, column);
}

void GuidedTestPanel::showSteps() {
    const int at = m_test ? static_cast<int>(m_test->step()) : -1;
    const bool done = m_test && m_test->step() == GuidedTest::Step::Done;
    for (int i = 0; i < kSteps; ++i) {
        Tone tone = Tone::Idle;
        if (done || (isRunning() && i < at)) {
            tone = Tone::Good;
        } else if (isRunning() && i == at) {
            tone = Tone::Warn;
        }
        const auto which = static_cast<std::size_t>(i);
        setTone(*m_lamps[which], tone);
        QFont font = this->font();
        font.setBold(isRunning() && i == at);
        m_stepTexts[which]->setFont(font);
    }
}

void GuidedTestPanel::showResult() {
    const std::optional<ErrorRow> row = m_shown ? m_shown->result() : std::nullopt;
    const bool usable = row && row->solution.isUsable();
    for (int i = 0; i < 6; ++i) {
        const Row& shown = m_rows[static_cast<std::size_t>(i)];
        const auto number = [i](bool there, double si) {
            return there ? std::optional(toDisplay(i, si)) : std::nullopt;
        };
        shown.target->showNumber(number(m_shown.has_value(), m_shown ? m_shown->target().toVector()[i] : 0.0),
                                 kResultDecimals);
        shown.measured->showNumber(number(usable, usable ? row->solution.pose.toVector()[i] : 0.0),
                                   kResultDecimals);
        shown.error->showNumber(number(usable, usable ? row->error[i] : 0.0), kResultDecimals);
        shown.expected->showNumber(number(usable, usable ? row->predictedBound[i] : 0.0), kResultDecimals);
        m_lengths[static_cast<std::size_t>(i)]->showNumber(
            row ? std::optional(mmFromMetres(row->sample.meanLengths[i])) : std::nullopt, kResultDecimals);
    }
}

void GuidedTestPanel::retranslate() {
    label(*m_start, tr("Guided test"),
          tr("Go to the pose of the published test, wait until it has settled, average the lengths for 1 s, "
             "solve and compare; the platform moves"));
    const QString steps[] = {tr("Move to the pose"), tr("Wait until it has settled"),
                             tr("Average the lengths for 1 s"), tr("Solve and compare")};
    for (std::size_t i = 0; i < m_stepTexts.size(); ++i) {
        m_stepTexts[i]->setText(steps[i]);
    }
    m_heads[0]->setText(tr("target"));
    m_heads[1]->setText(tr("measured"));
    m_heads[2]->setText(tr("error"));
    m_heads[3]->setText(QString::fromUtf8("\u00b1 ") + tr("expected"));
    m_heads[3]->setToolTip(tr("The largest error that the 0.1 mm resolution of the lengths explains"));
    m_lengthsTitle->setText(tr("mean lengths, mm"));
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const QString word = coordinateTexts()[i].word;
        m_rows[i].target->setAccessibleName(tr("Test target %1").arg(word));
        m_rows[i].measured->setAccessibleName(tr("Test measured %1").arg(word));
        m_rows[i].error->setAccessibleName(tr("Test error %1").arg(word));
        m_rows[i].expected->setAccessibleName(tr("Test expected error %1").arg(word));
        m_lengths[i]->setAccessibleName(tr("Test length %1").arg(i + 1));
    }
    m_message->setAccessibleName(tr("Test progress"));
    m_message->showText(m_text());
    showSteps();
    showResult();
}

} // namespace hexapose
