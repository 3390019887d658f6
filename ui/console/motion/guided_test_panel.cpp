// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/guided_test_panel.h"

#include "ui/common/read_out.h"
#include "ui/common/status_text.h"
#include "ui/console/events/sequence_end_text.h"
#include "ui/console/motion/plan_start.h"

#include <QEvent>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

// What the guided test does; guided_test_layout.cpp is how it looks and what it says.
namespace hexapose {

GuidedTestPanel::GuidedTestPanel(const SharedModel& model, QWidget* parent)
    : QWidget(parent), m_planner(model, plannerSettings({}, model->geometry())),
      m_start(new QPushButton(this)) {
    m_start->setProperty("kind", "primary");
    m_start->setObjectName(QStringLiteral("guidedTest"));
    m_message = new TextReadOut(2, this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(5);
    column->addWidget(m_start);
    buildSteps(*column);
    buildResult(*column);
    column->addWidget(m_message);
    column->addStretch(1);
    connect(m_start, &QPushButton::clicked, this, &GuidedTestPanel::start);
    m_text = [] { return tr("Moves to the pose of the published test, measures it and compares"); };
    retranslate();
    updateButton();
}

void GuidedTestPanel::setSolver(std::shared_ptr<const ForwardSolver> solver) {
    m_solver = std::move(solver);
    updateButton();
}

void GuidedTestPanel::setConnected(bool connected) {
    m_connected = connected;
    if (!connected && isRunning()) {
        end([] { return tr("Ended: the connection was closed"); });
    }
    updateButton();
}

void GuidedTestPanel::showSnapshot(const Snapshot& snapshot) {
    m_planner.setControllerLimits(snapshot.minLength, snapshot.maxLength);
    m_from = planStart(snapshot);
    m_ready = runInhibit(snapshot).isEmpty() && m_from.has_value();
    updateButton();
}

void GuidedTestPanel::setMode(MotionMode mode) {
    m_mode = mode;
    if (isPlanning() && m_from) {
        plan();
    }
}

void GuidedTestPanel::start() {
    if (isRunning() || !m_solver || !m_ready) {
        return;
    }
    m_test.reset();
    m_ended = false;
    plan();
    showSteps();
    updateButton();
}

void GuidedTestPanel::plan() {
    m_planning.start(
        [planner = m_planner, from = *m_from, mode = m_mode](const Job& job) {
            return guidedPlan(planner, from, mode, planBudget(job));
        },
        [this](const Job::Outcome<SharedPlan>& outcome) { begin(outcome.result.value_or(nullptr)); });
}

void GuidedTestPanel::begin(const SharedPlan& plan) {
    if (!plan) {
        end([] { return tr("No pose of this test can be reached from here. Nothing moved."); });
        return;
    }
    if (!m_ready) { // any more
        end([] { return tr("The platform is not ready any more. Nothing moved."); });
        return;
    }
    m_plan = plan;
    m_test.emplace(m_planner.sharedModel(), m_solver, plan->endPose(), m_ids.take());
    setMessage([] { return tr("The test is under way; Stop ends it"); });
    showSteps();
    updateButton();
}

void GuidedTestPanel::add(const Snapshot& snapshot) {
    if (!isRunning() || !m_test) {
        return;
    }
    const GuidedTest::Step before = m_test->step();
    const bool accepted = m_test->accepted();
    const auto due = m_test->add(snapshot);
    if (m_test->accepted()) {
        m_shown = m_test; // until then the result of the one before stands
    }
    if (m_test->accepted() && !accepted) {
        showResult();
        emit runAccepted(m_test->target());
    }
    if (m_test->step() == GuidedTest::Step::Failed) {
        end([run = m_test->run()] { return tr("Ended early: %1").arg(sequenceEndText(run)); });
    } else if (m_test->step() == GuidedTest::Step::Done) {
        const int measurements = m_test->result()->sample.measurements;
        const SolveStatus status = m_test->result()->solution.status;
        end([=] {
            return tr("Done: %1 measurements averaged; solution: %2")
                .arg(QString::number(measurements), solveStatusText(status));
        });
    } else if (m_test->step() != before) {
        showSteps();
    }
    if (due) {
        emit runRequested(*due, m_test->run().id(), std::exchange(m_plan, nullptr));
    }
}

void GuidedTestPanel::stopped() {
    if (isRunning()) {
        end([] { return tr("Ended by Stop. Press Clear before the next one."); });
    }
}

void GuidedTestPanel::end(const Text& text) {
    m_planning.cancel();
    m_plan.reset();
    m_ended = true;
    setMessage(text);
    showSteps();
    showResult();
    updateButton();
}

void GuidedTestPanel::setMessage(const Text& text) {
    m_text = text;
    m_message->showText(text());
}

void GuidedTestPanel::updateButton() {
    m_start->setEnabled(!isRunning() && m_connected && m_ready && m_solver);
}

void GuidedTestPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_guided_test_panel.cpp"
