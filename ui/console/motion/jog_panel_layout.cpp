// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "ui/common/card.h"
#include "ui/common/read_out.h"
#include "ui/common/status_text.h"
#include "ui/console/motion/axis_range.h"
#include "ui/console/motion/jog_panel.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QPushButton>

// How the jog panel looks and what it says; jog_panel.cpp is what it does.
namespace hexapose {

namespace {
constexpr int kRangesEveryMs = 250;
constexpr int kHintLines = 3;
constexpr double kJogSteps[] = {0.1, 1.0, 5.0}; // mm or degrees
} // namespace

void JogPanel::build() {
    m_frame = new QComboBox(this);
    m_frameLabel = new QLabel(this);
    m_step = new QComboBox(this);
    m_stepLabel = new QLabel(this);
    m_frameLabel->setBuddy(m_frame); // on Linux a box is named by its label alone
    m_stepLabel->setBuddy(m_step);
    m_frame->addItems({QString(), QString()});
    m_step->addItem(QString(), 0.0);
    for (const double step : kJogSteps) {
        m_step->addItem(QString::fromStdString(formatNumber(step)) + QString::fromUtf8(" mm / \u00b0"), step);
    }
    auto* choices = new QGridLayout;
    choices->setHorizontalSpacing(6);
    choices->addWidget(m_frameLabel, 0, 0);
    choices->addWidget(m_frame, 0, 1);
    choices->addWidget(m_stepLabel, 0, 2);
    choices->addWidget(m_step, 0, 3);
    choices->setColumnStretch(1, 1);
    choices->setColumnStretch(3, 1);

    m_pad = new QWidget(this);
    m_pad->setObjectName(QStringLiteral("jogPad"));
    m_pad->setFocusPolicy(Qt::StrongFocus);
    m_pad->installEventFilter(this);
    auto* grid = new QGridLayout(m_pad);
    grid->setContentsMargins(6, 4, 6, 4); // room for the mark of the focus
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(5);
    m_rangeHeads = {makeMutedLabel(m_pad, Qt::AlignRight | Qt::AlignVCenter), makeMutedLabel(m_pad)};
    grid->addWidget(m_rangeHeads[0], 0, 0, 1, 2, Qt::AlignLeft);
    grid->addWidget(m_rangeHeads[1], 0, 3, 1, 2, Qt::AlignRight);
    for (int axis = 0; axis < 6; ++axis) {
        addRow(*grid, axis);
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    m_hint = new TextReadOut(kHintLines, this);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addLayout(choices);
    column->addWidget(m_pad);
    column->addWidget(m_hint);
    column->addStretch(1);
    connect(m_frame, &QComboBox::currentIndexChanged, this, [this] {
        m_hold.end();
        m_sinceRanges.invalidate();
        showRanges();
    });
    connect(m_step, &QComboBox::currentIndexChanged, this, [this] {
        m_hold.end();
        m_tooSoon = false;
        showHint();
    });
}

void JogPanel::addRow(QGridLayout& grid, int axis) {
    const CoordinateText& text = coordinateTexts()[static_cast<std::size_t>(axis)];
    for (const bool up : {false, true}) {
        auto* made = new QPushButton(m_pad);
        made->setText((up ? QStringLiteral("+ ") : QString::fromUtf8("\u2212 ")) + text.symbol);
        made->installEventFilter(this);
        button(axis, up) = made;
        connect(made, &QPushButton::pressed, this,
                [this, made, axis, up] { buttonPressed(made, directionOf(axis, up)); });
        connect(made, &QPushButton::released, this, [this, made] {
            if (m_heldButton == made) {
                m_hold.end();
            }
        });
        connect(made, &QPushButton::clicked, this, [this, axis, up] { takeStep(directionOf(axis, up)); });
        QLabel* range = makeMutedLabel(m_pad, (up ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
        range->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-000.0")));
        m_ranges[slot(axis, up)] = range;
        grid.addWidget(range, axis + 1, up ? 4 : 0);
        grid.addWidget(made, axis + 1, up ? 3 : 1);
    }
    auto* unit = makeMutedLabel(m_pad, Qt::AlignCenter);
    unit->setText(text.unit);
    grid.addWidget(unit, axis + 1, 2);
}

void JogPanel::showRanges() {
    if (!isVisible() || (m_sinceRanges.isValid() && m_sinceRanges.elapsed() < kRangesEveryMs)) {
        return;
    }
    m_sinceRanges.start();
    const bool live = m_connected && !m_latest.stale && m_latest.measuredPose;
    for (int axis = 0; axis < 6; ++axis) {
        for (const bool up : {false, true}) {
            const auto free =
                live ? jogRange(m_planner, *m_latest.measuredPose, directionOf(axis, up)) : std::nullopt;
            m_ranges[slot(axis, up)]->setText(
                free ? QString::fromStdString(formatFixed(toDisplay(axis, *free), 1)) : ReadOut::dash());
        }
    }
}

/// Why it cannot be jogged now; empty when it can.
QString JogPanel::hindrance() const {
    if (!m_connected) {
        return tr("Connect first; a jog needs the drives on");
    }
    if (const QString why = linkInhibit(m_latest); !why.isEmpty()) {
        return why;
    }
    const CommandSet& allowed = m_latest.allowed;
    if (allowed.contains(Command::Jog) || m_jogging || m_stepping) {
        return {};
    }
    if (allowed.contains(Command::Clear)) {
        return tr("Press Clear and Enable first; a jog needs the drives on");
    }
    if (allowed.contains(Command::Enable) || !allowed.contains(Command::Disable)) {
        return tr("Press Enable first; a jog needs the drives on");
    }
    return allowed.contains(Command::Reference)
               ? tr("Press Reference and Enable first; a jog needs the drives on")
               : tr("Wait until the motion is over, or press Stop");
}

void JogPanel::showHint() {
    if (const QString why = hindrance(); !why.isEmpty()) {
        m_hint->showText(why);
    } else if (m_tooSoon) {
        m_hint->showText(tr("That step was not taken: the one before was still under way. Press again."));
    } else if (m_step->currentIndex() == 0) {
        m_hint->showText(tr("Moves while a button is held. Keys, with the focus here: arrows for x and y, "
                            "page up and down for z; hold Shift to rotate about the axis"));
    } else {
        m_hint->showText(tr("One step per click or key: arrows for x and y, page up and down for z; hold "
                            "Shift to rotate about the axis"));
    }
}

void JogPanel::retranslate() {
    m_frameLabel->setText(tr("Frame"));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_frameLabel, m_frame}) {
        widget->setAccessibleName(tr("Jog frame"));
    }
    m_frame->setItemText(0, tr("Base"));
    m_frame->setItemText(1, tr("Platform"));
    m_frame->setToolTip(
        tr("Along and about the axes of the base, or those of the platform in its present orientation"));
    m_stepLabel->setText(tr("Step"));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_stepLabel, m_step}) {
        widget->setAccessibleName(tr("Jog step"));
    }
    m_step->setItemText(0, tr("Hold"));
    m_step->setToolTip(
        tr("Hold: moves as long as a button is held. A number: moves by this many mm or degrees per click"));
    m_pad->setAccessibleName(tr("Jog keys"));
    const QString keys =
        tr("Keys, with the focus here: left and right x, down and up y, page down and page up "
           "z; hold Shift for alpha, beta, gamma. Letting go ends the motion.");
    m_pad->setToolTip(keys);
    for (int axis = 0; axis < 6; ++axis) {
        const QString word = coordinateTexts()[static_cast<std::size_t>(axis)].word;
        button(axis, false)->setAccessibleName(tr("Jog -%1").arg(word));
        button(axis, true)->setAccessibleName(tr("Jog +%1").arg(word));
        button(axis, false)->setToolTip(keys);
        button(axis, true)->setToolTip(keys);
    }
    for (QLabel* range : m_ranges) {
        range->setToolTip(tr("How far it can go in this direction from the present pose"));
    }
    for (QLabel* head : m_rangeHeads) {
        head->setText(tr("range left"));
    }
    m_hint->setAccessibleName(tr("Jog hint"));
    showHint();
}

void JogPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose
