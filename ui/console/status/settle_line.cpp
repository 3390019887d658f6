// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/status/settle_line.h"

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "ui/common/card.h"
#include "ui/common/read_out.h"
#include "ui/common/theme.h"

#include <QEvent>
#include <QHBoxLayout>

namespace hexapose {

namespace {
constexpr int kWindowDecimals = 2; // of mm and degrees
constexpr int kTimeDecimals = 1;   // of seconds
} // namespace

SettleLine::SettleLine(const SharedModel& model, QWidget* parent)
    : QWidget(parent), m_model(model), m_control(withDefaults(ControlOptions{}, model->geometry())),
      m_lamp(makeLamp(this)), m_text(new ReadOut(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(m_lamp);
    row->addWidget(m_text, 1);
    m_text->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    refresh();
}

void SettleLine::setControl(const ControlOptions& options) {
    m_control = withDefaults(options, m_model->geometry());
    refresh();
}

void SettleLine::add(const Snapshot& snapshot) {
    for (const Event& event : snapshot.events) {
        m_settled = m_settled || event.code == EventCode::Settled;
    }
    if (snapshot.state != RunState::Enabled) {
        m_settled = false;
    }
}

void SettleLine::showSnapshot(const Snapshot& snapshot) {
    m_state = snapshot.state;
    m_mode = snapshot.mode;
    m_stale = snapshot.stale;
    refresh();
}

QString SettleLine::windowText() const {
    const SettleWindow& window = m_control.settleWindow;
    const QString mm = QString::fromStdString(formatFixed(mmFromMetres(window.distance), kWindowDecimals));
    const QString deg = QString::fromStdString(formatFixed(degFromRadians(window.angle), kWindowDecimals));
    const QString time = QString::fromStdString(
        formatFixed(std::chrono::duration<double>(m_control.settleTime).count(), kTimeDecimals));
    return m_mode == MotionMode::Workspace ? tr("within %1 mm and %2\u00b0 for %3 s").arg(mm, deg, time)
                                           : tr("each leg within %1 mm for %2 s").arg(mm, time);
}

void SettleLine::refresh() {
    QString text = ReadOut::dash();
    Tone tone = Tone::Idle;
    if (m_state == RunState::Moving) {
        text = tr("Moving");
    } else if (m_state == RunState::Settling) {
        text = tr("Not settled yet: %1").arg(windowText());
        tone = Tone::Warn;
    } else if (m_state == RunState::Enabled && m_settled) {
        text = tr("Settled: %1").arg(windowText());
        tone = Tone::Good;
    }
    setTone(*m_lamp, m_stale ? Tone::Idle : tone);
    m_text->showText(text);
    m_text->setToolTip(text);
    m_text->setStale(m_stale);
    m_text->setAccessibleName(tr("Settled"));
}

void SettleLine::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_settle_line.cpp"
