// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/record/snapshot.h"
#include "core/session/session.h"
#include "ui/console/status/connection_panel.h"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>

#include <memory>

class QButtonGroup;
class QMessageBox;
class QStackedWidget;

namespace hexapose {

class Banner;
class ChartPage;
class EventList;
class LegsPanel;
class MotionPanel;
class PosePanel;
class ReportPanel;
class StatusPanel;
class TargetPanel;
struct ThemeColors;

/// The operator's window: Figure 7 made modern. Everything on it comes from snapshots that it polls on its
/// own tick.
class OperatorWindow final : public QMainWindow {
    Q_OBJECT
public:
    OperatorWindow(const SharedModel& model, PortList ports, QWidget* parent = nullptr);
    ~OperatorWindow() override;

    void setColors(const ThemeColors& colors);
    /// Until then there is nothing to connect with.
    void setSession(std::unique_ptr<Session> session);
    Session* session() const { return m_session.get(); }
    /// Another solver for the session: at once while it is closed, else as soon as nothing moves.
    void setSolver(const std::shared_ptr<const ForwardSolver>& solver, const std::string& modelFingerprint);
    void connectTo(const ConnectionSpec& connection);
    void disconnectFrom();

    /// One display tick's worth; the tick calls it, and so may a test.
    void showSnapshots(const std::vector<SnapshotPtr>& snapshots);
    const Snapshot& latest() const { return m_latest; }

    Banner& banner() { return *m_banner; }
    ChartPage& charts() { return *m_charts; }
    ConnectionPanel& connectionPanel() { return *m_connection; }
    EventList& events() { return *m_events; }
    ReportPanel& reportPanel() { return *m_report; }
    MotionPanel& motionPanel() { return *m_motion; }
    TargetPanel& targetPanel();
    void showPage(int page); ///< 0: the console, 1: the report

signals:
    /// Each event of the engine, as it reaches the screen.
    void eventHappened(const hexapose::Event& event);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void build();
    QWidget* buildHeader();
    QWidget* buildConsole();
    void wire();
    void post(const OperatorCommand& command);
    void tick();
    void showLatest();
    void followSolver();
    void sessionOpened();
    void sessionClosed();
    void askBeforeClosing();
    void retranslate();

    std::unique_ptr<Session> m_session;
    SnapshotReader m_reader;                       ///< of the session, for all that is on the screen
    std::shared_ptr<const ForwardSolver> m_solver; ///< that is shown: the one in use
    Snapshot m_latest;
    QElapsedTimer m_sinceSnapshot;
    QTimer m_tick;
    int m_tickCount = 0;
    bool m_closeAllowed = false;

    ConnectionPanel* m_connection;
    Banner* m_banner;
    MotionPanel* m_motion;
    EventList* m_events;
    ChartPage* m_charts;
    LegsPanel* m_legs;
    PosePanel* m_pose;
    ReportPanel* m_report;
    StatusPanel* m_status;
    QStackedWidget* m_pages = nullptr;
    QButtonGroup* m_pageGroup = nullptr;
    QPushButton* m_consolePage = nullptr;
    QPushButton* m_reportPage = nullptr;
    QPushButton* m_export = nullptr;
    QMessageBox* m_question = nullptr;
};

} // namespace hexapose
