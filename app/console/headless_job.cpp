// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/headless_job.h"

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/report/error_report.h"
#include "ui/common/number_field.h"
#include "ui/common/status_text.h"
#include "ui/console/events/event_list.h"
#include "ui/console/motion/target_panel.h"
#include "ui/console/report/report_panel.h"

#include <QApplication>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPixmap>
#include <QPushButton>

#include <array>
#include <cmath>
#include <cstdio>

namespace hexapose {

namespace {

constexpr int kLookEveryMs = 50;
constexpr qint64 kStepTimeoutMs = 150000; // a machine may take two minutes to find its reference
constexpr int kReportAttitudes = 3;       // enough to show the report without a long wait
constexpr std::uint64_t kSeed = 1;
/// The attitude of the published test.
constexpr std::array<double, 6> kTarget{12.0, -4.0, 40.0, 0.0, 0.0, 5.0};

void typeInto(NumberField& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    for (const QChar letter : text) {
        QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, QString(letter));
        QApplication::sendEvent(&field, &press);
    }
}

} // namespace

HeadlessJob::HeadlessJob(OperatorWindow& window, const std::filesystem::path& output, QObject* parent)
    : QObject(parent), m_window(window), m_output(output) {
    m_timer.setInterval(kLookEveryMs);
    connect(&m_timer, &QTimer::timeout, this, &HeadlessJob::advance);
}

void HeadlessJob::start() {
    connect(&m_window, &OperatorWindow::eventHappened, this, &HeadlessJob::watch);
    connect(&m_window.reportPanel(), &ReportPanel::exported, this, [this](const QStringList& files) {
        m_files = files;
        savePicture();
    });
    connect(&m_window.reportPanel(), &ReportPanel::finished, this, [this](bool complete) {
        if (m_step != Step::Reporting) {
            return;
        }
        if (!complete) {
            fail(QStringLiteral("the report: ") + m_window.reportPanel().progressText());
            return;
        }
        m_step = Step::Exporting;
        m_sinceStep.start();
        press("exportReport");
    });
    m_sinceStep.start();
    m_timer.start();
}

void HeadlessJob::advance() {
    try {
        nextStep();
    } catch (const InputError& error) {
        fail(QString::fromUtf8(error.what()));
    }
}

void HeadlessJob::nextStep() {
    const Snapshot& now = m_window.latest();
    if (m_sinceStep.elapsed() > kStepTimeoutMs) {
        fail(QStringLiteral("timed out; last event: ") + m_window.events().textAt(0));
    } else if (m_step == Step::Connecting && now.link == LinkState::ListenOnly) {
        fail(QStringLiteral("an unprotected sender of lengths takes no commands"));
    } else if (m_step == Step::Connecting && now.state != RunState::Disconnected && now.measuredPose &&
               !now.stale) {
        typeTarget();
        m_step = Step::Starting;
        m_sinceStep.start();
        press("run");
    } else if (m_step == Step::Starting &&
               (now.state == RunState::Moving || now.state == RunState::Settling)) {
        m_step = Step::Moving;
    } else if (m_step == Step::Moving && now.state == RunState::Enabled) {
        startReport();
    } else if ((m_step == Step::Starting || m_step == Step::Moving) &&
               (now.state == RunState::Stopped || now.state == RunState::Fault)) {
        fail(QStringLiteral("the move ended early: ") + m_window.events().textAt(0));
    }
}

/// An event after which the first move will not come about.
void HeadlessJob::watch(const Event& event) {
    const bool over = event.code == EventCode::MoveRefused || event.code == EventCode::CommandRefused ||
                      event.code == EventCode::PreparationFailed || event.code == EventCode::NotSettled ||
                      event.code == EventCode::LoopFailed;
    if (over && (m_step == Step::Starting || m_step == Step::Moving)) {
        fail(eventText(event).cause);
    }
}

void HeadlessJob::typeTarget() {
    std::array<double, 6> shown = kTarget;
    type(shown);
    if (m_window.targetPanel().check() && m_window.targetPanel().check()->ok()) {
        return;
    }
    // Not for this machine: one that it can reach.
    const PoseVector si = defaultPoses(m_window.session()->setup().geometry, 1, kSeed).front().toVector();
    for (int i = 0; i < 6; ++i) {
        shown[static_cast<std::size_t>(i)] = std::round(1e3 * toDisplay(i, si[i])) / 1e3;
    }
    type(shown);
}

void HeadlessJob::type(const std::array<double, 6>& shown) {
    for (std::size_t i = 0; i < shown.size(); ++i) {
        typeInto(*m_window.targetPanel().fields()[i], QString::fromStdString(formatNumber(shown[i])));
    }
}

void HeadlessJob::startReport() {
    m_step = Step::Reporting;
    m_sinceStep.start();
    const PlatformGeometry& geometry = m_window.session()->setup().geometry;
    m_logFile = m_window.session()->logFile();
    if (!m_output.empty()) {
        m_window.reportPanel().setFolder(QString::fromStdString(m_output.string()));
    }
    m_window.reportPanel().runList(defaultPoses(geometry, kReportAttitudes, kSeed));
}

void HeadlessJob::press(const char* button) {
    if (auto* found = m_window.findChild<QPushButton*>(QString::fromLatin1(button))) {
        found->click();
    }
}

void HeadlessJob::savePicture() {
    const QString picture = m_window.reportPanel().folder() + QStringLiteral("/console.png");
    if (!m_window.grab().save(picture)) {
        fail(QStringLiteral("cannot write ") + picture);
        return;
    }
    std::printf("log: %s\n", qPrintable(m_logFile));
    for (const QString& file : m_files) {
        std::printf("report: %s\n", qPrintable(file));
    }
    std::printf("picture: %s\n", qPrintable(picture));
    end(0);
}

void HeadlessJob::fail(const QString& reason) {
    std::fprintf(stderr, "hexapose: %s\n", qPrintable(reason));
    end(1);
}

void HeadlessJob::end(int exitStatus) {
    m_step = Step::Ended;
    m_timer.stop();
    m_window.disconnectFrom();
    emit finished(exitStatus);
}

} // namespace hexapose
