// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/status/banner.h"

#include "core/base/number_text.h"
#include "ui/common/card.h"
#include "ui/common/read_out.h"
#include "ui/console/events/event_text.h"
#include "ui/console/events/payload_text.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace hexapose {

namespace {
constexpr int kProgressSteps = 1000;
}

Banner::Banner(QWidget* parent)
    : QFrame(parent), m_lamp(makeLamp(this)), m_text(new ReadOut(this)), m_progress(new QProgressBar(this)),
      m_cancel(new QPushButton(this)) {
    setObjectName(QStringLiteral("banner"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 4, 12, 4);
    row->addWidget(m_lamp);
    row->addWidget(m_text, 1);
    row->addWidget(m_progress, 1);
    row->addWidget(m_cancel);
    m_text->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_progress->setRange(0, kProgressSteps);
    connect(m_cancel, &QPushButton::clicked, this, &Banner::cancelRequested);
    refresh();
}

void Banner::showSnapshot(const Snapshot& snapshot, bool open) {
    m_snapshot = snapshot;
    m_open = open;
    for (const Event& event : snapshot.events) {
        if (event.code == EventCode::LinkLost || event.code == EventCode::LoopFailed) {
            m_lossCause = event;
        }
    }
    refresh();
}

void Banner::showClosed() {
    m_open = false;
    m_lossCause.reset();
    refresh();
}

void Banner::showLogFailure(const std::optional<LogFailure>& failure) {
    m_logFailure = failure;
    refresh();
}

void Banner::showTraining(double part) {
    m_training = true;
    m_trainingFailure.clear();
    m_progress->setValue(static_cast<int>(part * kProgressSteps));
    refresh();
}

void Banner::endTraining(const QString& failure) {
    m_training = false;
    m_trainingFailure = failure;
    refresh();
}

/// Nobody reconnects where the loop itself has ended.
QString Banner::lossText() const {
    if (m_lossCause && m_lossCause->code == EventCode::LoopFailed) {
        return tr("The control loop ended: %1. Disconnect and connect again.")
            .arg(loopFailureText(*m_lossCause));
    }
    const QString cause = m_lossCause ? payloadText(m_lossCause->data) : QString();
    return cause.isEmpty() ? tr("Connection lost - reconnecting")
                           : tr("Connection lost: %1 - reconnecting").arg(cause);
}

void Banner::refresh() {
    const QString age =
        QString::fromStdString(formatFixed(std::chrono::duration<double>(m_snapshot.age).count(), 1));
    QString text;
    Tone tone = Tone::Bad;
    if (m_training) {
        text = tr("Training the model of this platform; it is kept for the next time");
        tone = Tone::Idle;
    } else if (!m_trainingFailure.isEmpty()) {
        text = m_trainingFailure;
    } else if (m_open && m_snapshot.link == LinkState::Lost) {
        text = lossText();
    } else if (m_open && m_snapshot.link == LinkState::Connecting) {
        text = tr("Waiting for the controller to answer");
        tone = Tone::Warn;
    } else if (m_open && !m_snapshot.measuredLengths) {
        text = tr("Waiting for the first measurement");
        tone = Tone::Warn;
    } else if (m_open && m_snapshot.stale) {
        text = tr("No valid measurement for %1 s: the values shown are old").arg(age);
    } else if (m_logFailure) {
        const QString what = payloadText(*m_logFailure);
        text = m_logFailure->system.empty() ? tr("The log is not complete: %1").arg(what)
                                            : tr("The log cannot be written: %1").arg(what);
    } else if (m_open && m_snapshot.link == LinkState::ListenOnly) {
        text = tr("Listen-only source without checksums: transmission errors go unnoticed, and it takes no "
                  "commands");
        tone = Tone::Warn;
    }
    m_progress->setVisible(m_training);
    m_cancel->setVisible(m_training);
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAccessibleName(tr("Cancel the training"));
    m_progress->setAccessibleName(tr("Training progress"));
    m_text->setAccessibleName(tr("Message"));
    m_text->showText(text);
    setTone(*m_lamp, tone);
    setTone(*this, tone);
    setVisible(!text.isEmpty());
}

void Banner::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
    QFrame::changeEvent(event);
}

} // namespace hexapose

#include "moc_banner.cpp"
