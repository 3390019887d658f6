// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/motion_panel.h"

#include "ui/common/labelled.h"
#include "ui/console/motion/guided_test_panel.h"
#include "ui/console/motion/jog_panel.h"
#include "ui/console/motion/speed_control.h"
#include "ui/console/motion/target_panel.h"
#include "ui/console/motion/way_points_panel.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

namespace hexapose {

namespace {
constexpr int kStopHeight = 38;
constexpr int kWorkspaceIndex = 1;
} // namespace

MotionPanel::MotionPanel(const SharedModel& model, QWidget* parent)
    : Card(parent), m_modeLabel(new QLabel(this)), m_mode(new QComboBox(this)),
      m_speed(new SpeedControl(this)), m_tabs(new QTabBar(this)), m_stack(new QStackedWidget(this)),
      m_target(new TargetPanel(model, this)), m_jog(new JogPanel(model, this)),
      m_wayPoints(new WayPointsPanel(model, this)), m_test(new GuidedTestPanel(model, this)),
      m_stop(new QPushButton(this)) {
    build();
    wire();
    retranslate();
}

void MotionPanel::build() {
    m_modeLabel->setBuddy(m_mode); // on Linux a box is named by its label alone
    m_mode->addItems({QString(), QString()});
    auto* top = new QHBoxLayout;
    top->setSpacing(6);
    top->addWidget(m_modeLabel);
    top->addWidget(m_mode);
    top->addSpacing(4);
    top->addWidget(m_speed, 1);
    body()->addLayout(top);

    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(true);
    m_tabs->setUsesScrollButtons(false);
    m_tabs->setElideMode(Qt::ElideNone);
    for (QWidget* page : std::initializer_list<QWidget*>{m_target, m_jog, m_wayPoints, m_test}) {
        m_tabs->addTab(QString());
        m_stack->addWidget(page);
    }
    body()->addWidget(m_tabs);
    body()->addWidget(m_stack, 1);

    m_stop->setProperty("kind", "stop");
    m_stop->setObjectName(QStringLiteral("stop"));
    m_stop->setMinimumHeight(kStopHeight);
    body()->addWidget(m_stop);
}

void MotionPanel::wire() {
    connect(m_tabs, &QTabBar::currentChanged, m_stack, &QStackedWidget::setCurrentIndex);
    connect(m_mode, &QComboBox::currentIndexChanged, this, [this] {
        m_target->setMode(mode());
        m_wayPoints->setMode(mode());
        m_test->setMode(mode());
    });
    connect(m_speed, &SpeedControl::overrideRequested, this,
            [this](double speedOverride) { emit commandRequested(SpeedCommand{speedOverride}); });
    connect(m_stop, &QPushButton::clicked, this, &MotionPanel::stop);
    auto* stopKey = new QShortcut(QKeySequence(Qt::Key_Escape), this);
    stopKey->setContext(Qt::ApplicationShortcut);
    connect(stopKey, &QShortcut::activated, this, &MotionPanel::stop);

    // What is asked for here changes nothing by itself: a list or a test ends when the loop has accepted
    // another motion, which it sees in the snapshots.
    const auto run = [this](const Pose& pose, MotionId id, const SharedPlan& plan) {
        emit commandRequested(RunCommand{pose, mode(), id, plan});
    };
    connect(m_target, &TargetPanel::runRequested, this, run);
    connect(m_wayPoints, &WayPointsPanel::runRequested, this, run);
    connect(m_test, &GuidedTestPanel::runRequested, this, run);
    connect(m_wayPoints, &WayPointsPanel::runAccepted, m_target, &TargetPanel::setTarget);
    connect(m_test, &GuidedTestPanel::runAccepted, m_target, &TargetPanel::setTarget);
    connect(m_jog, &JogPanel::stepRequested, this, [this](const Pose& pose, MotionId id) {
        emit commandRequested(RunCommand{pose, MotionMode::Workspace, id});
    });
    connect(m_jog, &JogPanel::jogRequested, this, [this](const JogDirection& direction, MotionId id) {
        emit commandRequested(JogCommand{direction, 1.0, id});
    });
    connect(m_jog, &JogPanel::releaseRequested, this, [this] { emit commandRequested(JogReleaseCommand{}); });
    m_wayPoints->setTargetSource([this] { return m_target->target(); });
    connect(m_target, &TargetPanel::targetEdited, m_wayPoints, &WayPointsPanel::updateButtons);
    connect(m_wayPoints, &WayPointsPanel::holdRequested, this, [this](bool hold) {
        emit commandRequested(hold ? OperatorCommand(HoldCommand{}) : OperatorCommand(ResumeCommand{}));
    });
}

void MotionPanel::stop() {
    // First of all the stop itself: nothing else may come before it.
    emit stopRequested();
    m_jog->release();
    m_wayPoints->stopped();
    m_test->stopped();
}

MotionMode MotionPanel::mode() const {
    return m_mode->currentIndex() == kWorkspaceIndex ? MotionMode::Workspace : MotionMode::Joint;
}

void MotionPanel::setControl(const ControlOptions& options) {
    m_target->setControl(options);
    m_jog->setControl(options);
    m_wayPoints->setControl(options);
    m_test->setControl(options);
}

void MotionPanel::setSolver(std::shared_ptr<const ForwardSolver> solver) {
    m_test->setSolver(std::move(solver));
}

void MotionPanel::sessionOpened() {
    m_speed->sendOverride();
}

void MotionPanel::setConnected(bool connected) {
    m_target->setConnected(connected);
    m_jog->setConnected(connected);
    m_wayPoints->setConnected(connected);
    m_test->setConnected(connected);
}

void MotionPanel::add(const Snapshot& snapshot) {
    m_jog->add(snapshot);
    m_wayPoints->add(snapshot);
    m_test->add(snapshot);
}

void MotionPanel::showSnapshot(const Snapshot& snapshot) {
    m_target->showSnapshot(snapshot);
    m_jog->showSnapshot(snapshot);
    m_wayPoints->showSnapshot(snapshot);
    m_test->showSnapshot(snapshot);
    m_speed->showSnapshot(snapshot);
}

void MotionPanel::showPage(Page page) {
    m_tabs->setCurrentIndex(page);
}

void MotionPanel::retranslate() {
    setTitle(tr("Motion"));
    m_modeLabel->setText(tr("Mode"));
    m_mode->setAccessibleName(tr("Mode"));
    m_mode->setItemText(0, tr("Joint"));
    m_mode->setItemText(kWorkspaceIndex, tr("Workspace"));
    m_mode->setToolTip(
        tr("Joint: each leg changes its length steadily. Workspace: the platform moves in a straight "
           "line, corrected by its measured pose. Changing it moves nothing."));
    m_tabs->setAccessibleName(tr("Motion pages"));
    m_tabs->setTabText(Target, tr("Target"));
    m_tabs->setTabText(Jog, tr("Jog"));
    m_tabs->setTabText(WayPoints, tr("Way-points"));
    m_tabs->setTabText(Test, tr("Test"));
    label(*m_stop, tr("Stop  (Esc)"), tr("Stop"),
          tr("Stop the motion (Esc). This is not the emergency stop of the machine."));
}

void MotionPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    Card::changeEvent(event);
}

} // namespace hexapose

#include "moc_motion_panel.cpp"
