// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/speed_control.h"

#include "ui/common/card.h"
#include "ui/common/read_out.h"
#include "ui/common/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QSlider>

#include <cmath>

namespace hexapose {

namespace {
constexpr int kSlowestPercent = 5;
constexpr int kFullPercent = 100;
constexpr int kSpeedStep = 5;          // percent
constexpr int kSliderHeight = 24;      // the whole of the handle
constexpr int kSendAgainMs = 250;      // a command takes a cycle or two to show
constexpr double kSameOverride = 1e-6; // of full speed
} // namespace

SpeedControl::SpeedControl(QWidget* parent)
    : QWidget(parent), m_label(makeCaption(this)), m_slider(new QSlider(Qt::Horizontal, this)),
      m_readOut(new ReadOut(this)) {
    m_slider->setRange(kSlowestPercent, kFullPercent);
    m_slider->setSingleStep(kSpeedStep);
    m_slider->setPageStep(2 * kSpeedStep);
    m_slider->setValue(kFullPercent);
    m_slider->setMinimumWidth(60);
    m_slider->setMinimumHeight(kSliderHeight);
    m_readOut->setDigits(6);
    m_readOut->setMaximumWidth(m_readOut->minimumWidth());
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(m_label);
    row->addWidget(m_slider, 1);
    row->addWidget(m_readOut);
    connect(m_slider, &QSlider::valueChanged, this, [this] {
        showOverride();
        sendOverride();
    });
    retranslate();
}

double SpeedControl::speedOverride() const {
    return static_cast<double>(m_slider->value()) / kFullPercent;
}

void SpeedControl::sendOverride() {
    m_sinceSent.start();
    emit overrideRequested(speedOverride());
}

void SpeedControl::showSnapshot(const Snapshot& snapshot) {
    if (snapshot.held != m_held) {
        m_held = snapshot.held;
        showOverride();
    }
    const bool loop = snapshot.link != LinkState::Lost && snapshot.measuredLengths.has_value();
    const bool differs = std::abs(snapshot.speed - speedOverride()) > kSameOverride;
    if (loop && differs && (!m_sinceSent.isValid() || m_sinceSent.elapsed() > kSendAgainMs)) {
        sendOverride();
    }
}

void SpeedControl::showOverride() {
    m_readOut->showText(m_held ? tr("held") : QStringLiteral("%1 %").arg(m_slider->value()));
    setTone(*m_readOut, m_held ? Tone::Warn : Tone::Idle);
}

void SpeedControl::retranslate() {
    setCaption(*m_label, tr("Speed"));
    m_slider->setAccessibleName(tr("Speed"));
    m_slider->setToolTip(
        tr("Speed override: per cent of full speed for every motion; may be changed during a move"));
    m_readOut->setAccessibleName(tr("Speed in force"));
    showOverride();
}

void SpeedControl::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_speed_control.cpp"
