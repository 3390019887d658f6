// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/window/operator_window.h"

#include "core/base/input_error.h"
#include "ui/charts/chart_page.h"
#include "ui/common/wheel_guard.h"
#include "ui/console/events/event_list.h"
#include "ui/console/events/input_fault_text.h"
#include "ui/console/motion/motion_panel.h"
#include "ui/console/motion/target_panel.h"
#include "ui/console/report/report_panel.h"
#include "ui/console/status/banner.h"
#include "ui/console/status/legs_panel.h"
#include "ui/console/status/pose_panel.h"
#include "ui/console/status/settle_line.h"
#include "ui/console/status/status_panel.h"

#include <QApplication>
#include <QButtonGroup>
#include <QCloseEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>

namespace hexapose {

namespace {

constexpr int kTickMs = 33;     // about 30 a second
constexpr int kChartsEvery = 2; // ticks: curves are drawn 15 times a second
constexpr int kSilenceMs = 500; // a loop that gives nothing for so long has stalled

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

} // namespace

OperatorWindow::OperatorWindow(const SharedModel& model, PortList ports, QWidget* parent)
    : QMainWindow(parent), m_connection(new ConnectionPanel(std::move(ports), this)),
      m_banner(new Banner(this)), m_motion(new MotionPanel(model, this)), m_events(new EventList(this)),
      m_charts(new ChartPage(model, this)), m_legs(new LegsPanel(model, this)),
      m_pose(new PosePanel(model, this)), m_report(new ReportPanel(model, this)),
      m_status(new StatusPanel(this)) {
    build();
    wire();
    m_status->setPlatform(QString::fromStdString(model->geometry().name));
    retranslate();
    m_tick.setInterval(kTickMs);
    qApp->installEventFilter(this);
    new WheelGuard(this);
    connect(&m_tick, &QTimer::timeout, this, &OperatorWindow::tick);
    m_tick.start();
}

OperatorWindow::~OperatorWindow() {
    delete m_question; // while there still is a window that it can tell
}

void OperatorWindow::wire() {
    connect(m_connection, &ConnectionPanel::connectRequested, this, &OperatorWindow::connectTo);
    connect(m_connection, &ConnectionPanel::disconnectRequested, this, &OperatorWindow::disconnectFrom);
    connect(m_connection, &ConnectionPanel::commandRequested, this, &OperatorWindow::post);
    connect(m_motion, &MotionPanel::commandRequested, this, &OperatorWindow::post);
    connect(m_motion, &MotionPanel::stopRequested, this, [this] {
        post(StopCommand{});
        m_report->stopped();
    });
    connect(m_report, &ReportPanel::runRequested, this, [this](const Pose& pose, MotionId id) {
        post(RunCommand{pose, m_motion->mode(), id});
    });
    connect(m_report, &ReportPanel::noted, this, [this](const std::function<EventText()>& text) {
        m_events->addNote(text, std::chrono::system_clock::now());
    });
    connect(m_export, &QPushButton::clicked, m_report, &ReportPanel::exportReport);
    // Toggled and not clicked: a screen reader toggles.
    connect(m_pageGroup, &QButtonGroup::idToggled, this, [this](int id, bool on) {
        if (on) {
            m_pages->setCurrentIndex(id);
        }
    });
}

void OperatorWindow::post(const OperatorCommand& command) {
    if (m_session && m_session->isOpen()) {
        m_session->post(command);
    }
}

TargetPanel& OperatorWindow::targetPanel() {
    return m_motion->target();
}

void OperatorWindow::setColors(const ThemeColors& colors) {
    m_charts->setColors(colors);
}

void OperatorWindow::setSession(std::unique_ptr<Session> session) {
    m_session = std::move(session);
    m_reader = m_session->reader();
    m_motion->setControl(m_session->setup().control);
    m_legs->settleLine().setControl(m_session->setup().control);
    m_connection->setSolver(m_session->setup().solver->name());
    m_connection->setAvailable(true);
    followSolver();
}

void OperatorWindow::setSolver(const std::shared_ptr<const ForwardSolver>& solver,
                               const std::string& modelFingerprint) {
    m_session->setSolver(solver, modelFingerprint);
    m_connection->setSolver(solver->name());
    followSolver();
}

/// What is shown is the solver that the loop has, not the one that was asked for.
void OperatorWindow::followSolver() {
    std::shared_ptr<const ForwardSolver> solver = m_session->solver();
    if (solver == m_solver) {
        return;
    }
    m_solver = std::move(solver);
    m_report->setSolver(m_solver);
    m_motion->setSolver(m_solver);
    m_status->setSolver(m_solver->name());
}

void OperatorWindow::connectTo(const ConnectionSpec& connection) {
    if (!m_session) {
        return;
    }
    disconnectFrom();
    m_connection->setChoice(connection);
    try {
        m_session->open(connection);
        sessionOpened();
    } catch (const InputError& error) {
        m_events->addNote(
            [error] {
                return EventText{
                    tr("The log cannot be created, so nothing was connected: %1").arg(inputFaultText(error)),
                    tr("Free space or choose another folder with --log-dir."), Tone::Bad};
            },
            std::chrono::system_clock::now());
    }
}

void OperatorWindow::disconnectFrom() {
    if (m_session && m_session->isOpen()) {
        m_session->close();
        sessionClosed();
    }
}

void OperatorWindow::sessionOpened() {
    m_charts->clear();
    m_report->clearSamples();
    const QFileInfo log(QString::fromStdString(m_session->logFile().string()));
    m_report->setDefaultFolder(log.path() + QLatin1Char('/') + log.completeBaseName() +
                               QStringLiteral("-report"));
    m_connection->setOpen(true);
    m_motion->sessionOpened();
    m_latest = Snapshot{};
    m_sinceSnapshot.start();
    showLatest();
}

void OperatorWindow::sessionClosed() {
    showSnapshots(m_reader.take()); // the events of the closing
    m_connection->setOpen(false);
    m_banner->showClosed();
    followSolver();
    m_latest = Snapshot{};
    m_latest.counters = {};
    showLatest();
}

void OperatorWindow::tick() {
    if (!m_session || !m_session->isOpen()) {
        return;
    }
    m_banner->showLogFailure(m_session->logFailure());
    showSnapshots(m_reader.take());
    followSolver();
}

void OperatorWindow::showSnapshots(const std::vector<SnapshotPtr>& snapshots) {
    for (const SnapshotPtr& one : snapshots) {
        const Snapshot& snapshot = *one;
        m_charts->add(snapshot);
        m_report->add(snapshot);
        m_motion->add(snapshot);
        m_legs->settleLine().add(snapshot);
        for (const Event& event : snapshot.events) {
            m_events->add(event, snapshot.wallTime);
            emit eventHappened(event);
        }
        m_banner->showSnapshot(snapshot, true);
    }
    if (!snapshots.empty()) {
        m_latest = *snapshots.back();
        m_sinceSnapshot.start();
    } else if (m_sinceSnapshot.isValid() && m_sinceSnapshot.elapsed() > kSilenceMs) {
        // The loop itself is silent: what it last said is old, however fresh it was then.
        m_latest.stale = true;
        m_latest.age += std::chrono::milliseconds(m_sinceSnapshot.restart());
        m_banner->showSnapshot(m_latest, true);
    }
    showLatest();
}

void OperatorWindow::showLatest() {
    const bool linked = m_latest.state != RunState::Disconnected;
    m_legs->showSnapshot(m_latest);
    m_pose->showSnapshot(m_latest);
    m_status->showSnapshot(m_latest);
    m_connection->showSnapshot(m_latest);
    m_motion->showSnapshot(m_latest);
    m_motion->setConnected(linked);
    m_report->showSnapshot(m_latest);
    m_report->setConnected(linked);
    if (++m_tickCount % kChartsEvery == 0) {
        m_charts->refreshInTurn(seconds(m_latest.time));
    }
}

void OperatorWindow::showPage(int page) {
    m_pageGroup->button(page)->setChecked(true);
}

/// A popup, a menu or a dialog takes Esc for itself, before the shortcut of Stop. It shall stop then too, at
/// the first press; what else it does there it goes on to do.
bool OperatorWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && watched->isWidgetType()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Escape && !key->isAutoRepeat()) {
            m_motion->stop();
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

void OperatorWindow::closeEvent(QCloseEvent* event) {
    if (!m_closeAllowed && m_session && m_session->isOpen() && drivesAreOn(m_latest.state)) {
        event->ignore();
        askBeforeClosing();
        return;
    }
    disconnectFrom();
    event->accept();
}

void OperatorWindow::askBeforeClosing() {
    if (m_question != nullptr) {
        m_question->raise();
        return;
    }
    m_question = new QMessageBox(QMessageBox::Question, tr("Close Hexapose"),
                                 tr("The platform is enabled. Stop it, disable it and close?"),
                                 QMessageBox::NoButton, this);
    m_question->setAttribute(Qt::WA_DeleteOnClose);
    m_question->setWindowModality(Qt::NonModal); // Stop stays within reach
    QPushButton* close = m_question->addButton(tr("Stop, disable and close"), QMessageBox::AcceptRole);
    QPushButton* stay = m_question->addButton(tr("Keep running"), QMessageBox::RejectRole);
    close->setAccessibleName(close->text());
    stay->setAccessibleName(stay->text());
    m_question->setDefaultButton(stay);
    connect(close, &QPushButton::clicked, this, [this] {
        m_closeAllowed = true;
        QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection);
    });
    connect(m_question, &QObject::destroyed, this, [this] { m_question = nullptr; });
    m_question->show();
}

} // namespace hexapose

#include "moc_operator_window.cpp"
