// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kinematics/forward_solver.h"
#include "core/machine/command.h"
#include "core/machine/control_options.h"
#include "core/record/snapshot.h"
#include "ui/common/card.h"

#include <memory>

class QComboBox;
class QPushButton;
class QStackedWidget;
class QTabBar;

namespace hexapose {

class GuidedTestPanel;
class JogPanel;
class SpeedControl;
class TargetPanel;
class WayPointsPanel;

/// Everything that can move the platform, in one place: mode and speed above, pages for target, jog,
/// way-points and the guided test, and below them Stop, whatever page is open.
class MotionPanel final : public Card {
    Q_OBJECT
public:
    enum Page { Target, Jog, WayPoints, Test };

    explicit MotionPanel(const SharedModel& model, QWidget* parent = nullptr);

    void setControl(const ControlOptions& options);
    void setSolver(std::shared_ptr<const ForwardSolver> solver);
    /// What a loop that has just begun has to know.
    void sessionOpened();
    void setConnected(bool connected);
    void add(const Snapshot& snapshot);          ///< every one
    void showSnapshot(const Snapshot& snapshot); ///< the latest

    MotionMode mode() const;
    void showPage(Page page);

    TargetPanel& target() { return *m_target; }
    JogPanel& jog() { return *m_jog; }
    WayPointsPanel& wayPoints() { return *m_wayPoints; }
    GuidedTestPanel& guidedTest() { return *m_test; }
    SpeedControl& speed() { return *m_speed; }

public slots:
    void stop();

signals:
    void commandRequested(const hexapose::OperatorCommand& command);
    void stopRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void wire();
    void retranslate();

    QLabel* m_modeLabel;
    QComboBox* m_mode;
    SpeedControl* m_speed;
    QTabBar* m_tabs;
    QStackedWidget* m_stack;
    TargetPanel* m_target;
    JogPanel* m_jog;
    WayPointsPanel* m_wayPoints;
    GuidedTestPanel* m_test;
    QPushButton* m_stop;
};

} // namespace hexapose
