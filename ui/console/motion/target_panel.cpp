// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/target_panel.h"

#include "core/base/number_text.h"
#include "ui/common/card.h"
#include "ui/common/labelled.h"
#include "ui/common/number_field.h"
#include "ui/common/read_out.h"
#include "ui/common/status_text.h"
#include "ui/common/theme.h"
#include "ui/console/events/motion_check_text.h"
#include "ui/console/motion/axis_range.h"
#include "ui/console/motion/named_poses.h"
#include "ui/console/motion/plan_start.h"

#include <QEvent>
#include <QGridLayout>
#include <QPushButton>
#include <QShowEvent>
#include <QVBoxLayout>

#include <utility>

namespace hexapose {

namespace {

constexpr int kCheckEveryMs = 250;
constexpr int kCheckInMotionEveryMs = 1000;
constexpr double kSamePlace = 1e-4;    // m
constexpr double kSameSetPoint = 2e-4; // m
constexpr int kPatienceMs = 200;
constexpr double kSameAttitude = 1e-3; // rad
constexpr int kValidityLines = 3;

QString rangeText(const std::pair<double, double>& range, int coordinate) {
    return QStringLiteral("%1 .. %2")
        .arg(QString::fromStdString(formatFixed(toDisplay(coordinate, range.first), 1)),
             QString::fromStdString(formatFixed(toDisplay(coordinate, range.second), 1)));
}

} // namespace

TargetPanel::TargetPanel(const SharedModel& model, QWidget* parent)
    : QWidget(parent), m_planner(model, plannerSettings({}, model->geometry())) {
    build();
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatienceMs);
    connect(&m_patience, &QTimer::timeout, this, &TargetPanel::showValidity);
    setTarget(Pose{});
    setConnected(false);
    retranslate();
    checkTarget();
}

void TargetPanel::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    buildFields(*column);
    buildValidity(*column);
    buildButtons(*column);
    m_named = new NamedPoses(this);
    column->addWidget(m_named);
    column->addStretch(1);
    connect(m_named, &NamedPoses::chosen, this, &TargetPanel::setTarget);
    connect(m_named, &NamedPoses::keepRequested, this, [this] {
        if (const auto pose = target()) {
            m_named->keep(*pose);
        }
    });
}

void TargetPanel::buildFields(QVBoxLayout& column) {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(5);
    m_rangeTitle = makeMutedLabel(this, Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(m_rangeTitle, 0, 1, 1, 3);
    for (int i = 0; i < 6; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const CoordinateText& text = coordinateTexts()[at];
        auto* field = new NumberField(coordinateBounds(i), this);
        field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        field->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0000.000")) + 18);
        m_fields[at] = field;
        connect(field, &NumberField::edited, this, &TargetPanel::checkTarget);
        auto* label = new QLabel(text.symbol, this);
        label->setMinimumWidth(16);
        m_ranges[at] = makeMutedLabel(this, Qt::AlignRight | Qt::AlignVCenter);
        m_ranges[at]->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-000.0 .. 000.0")));
        QLabel* unit = makeMutedLabel(this);
        unit->setText(text.unit);
        grid->addWidget(label, i + 1, 0);
        grid->addWidget(field, i + 1, 1);
        grid->addWidget(unit, i + 1, 2);
        grid->addWidget(m_ranges[at], i + 1, 3);
    }
    grid->setColumnStretch(1, 1);
    column.addLayout(grid);
}

void TargetPanel::buildValidity(QVBoxLayout& column) {
    auto* validity = new QHBoxLayout;
    m_lamp = makeLamp(this);
    m_validity = new TextReadOut(kValidityLines, this);
    auto* lampColumn = new QVBoxLayout;
    lampColumn->setContentsMargins(0, 3, 0, 0);
    lampColumn->addWidget(m_lamp);
    lampColumn->addStretch(1);
    validity->addLayout(lampColumn);
    validity->addWidget(m_validity, 1);
    validity->setContentsMargins(0, 2, 0, 0);
    column.addLayout(validity);
}

void TargetPanel::buildButtons(QVBoxLayout& column) {
    m_run = new QPushButton(this);
    m_run->setProperty("kind", "primary");
    m_run->setObjectName(QStringLiteral("run"));
    m_reset = new QPushButton(this);
    m_copy = new QPushButton(this);
    m_copy->setEnabled(false);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    buttons->addWidget(m_run, 1);
    buttons->addWidget(m_reset);
    buttons->addWidget(m_copy);
    column.addLayout(buttons);
    connect(m_run, &QPushButton::clicked, this, &TargetPanel::run);
    connect(m_reset, &QPushButton::clicked, this, [this] { setTarget(Pose{}); });
    connect(m_copy, &QPushButton::clicked, this, [this] {
        if (m_start) {
            setTarget(m_start->pose);
        }
    });
}

void TargetPanel::setControl(const ControlOptions& options) {
    m_planner.setSettings(plannerSettings(options, m_planner.model().geometry()));
    checkTarget();
}

void TargetPanel::setMode(MotionMode mode) {
    m_mode = mode;
    checkTarget();
}

void TargetPanel::setConnected(bool connected) {
    m_connected = connected;
    updateRun();
    showValidity();
}

void TargetPanel::updateRun() {
    const QString reason = runReason();
    m_run->setEnabled(reason.isEmpty());
    m_run->setToolTip(reason.isEmpty()
                          ? tr("Move to the target; references and enables first when that is needed")
                          : reason);
    m_run->setAccessibleDescription(m_run->toolTip());
}

/// The first field that is refused, and why; empty when the target is whole.
QString TargetPanel::refusedField() const {
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        if (m_fields[i]->isRefused()) {
            return tr("Target %1: %2").arg(coordinateTexts()[i].symbol, m_fields[i]->refusal());
        }
    }
    return {};
}

/// Why Run cannot be pressed; empty when it can.
QString TargetPanel::runReason() const {
    if (const QString refused = refusedField(); !refused.isEmpty()) {
        return refused;
    }
    if (!m_connected) {
        return tr("Cannot run: nothing is connected");
    }
    if (!m_hindrance.isEmpty()) {
        return m_hindrance;
    }
    if (m_check && !m_check->ok()) {
        return motionCheckText(*m_check);
    }
    if (!m_start) {
        return tr("Cannot run: no valid measurement received");
    }
    return isPlanned() ? QString() : tr("Checking the target");
}

/// Whether the plan is of exactly what stands in the fields, under the limits that hold.
bool TargetPanel::isPlanned() const {
    const auto pose = target();
    return pose && m_plan && m_plan->isFor({*pose, m_mode}) && m_plan->limits == m_planner.limits();
}

void TargetPanel::showSnapshot(const Snapshot& snapshot) {
    const bool hindered = !m_hindrance.isEmpty();
    if (const QString hindrance = runInhibit(snapshot); hindrance != m_hindrance) {
        m_hindrance = hindrance;
        updateRun();
        showValidity();
    }
    const bool had = m_start.has_value();
    m_start = planStart(snapshot);
    const MotionLimits before = m_planner.limits();
    m_planner.setControllerLimits(snapshot.minLength, snapshot.maxLength);
    m_copy->setEnabled(m_start.has_value());
    const bool moving = snapshot.state == RunState::Moving;
    const bool due = !m_sinceCheck.isValid() ||
                     (m_sinceCheck.elapsed() > (moving ? kCheckInMotionEveryMs : kCheckEveryMs) &&
                      !isPlanning() && hasMoved());
    if (had != m_start.has_value() || hindered != !m_hindrance.isEmpty() || !(before == m_planner.limits()) ||
        (due && isVisible())) {
        checkTarget();
    }
}

/// Since the last check, by more than the measurement's rounding.
bool TargetPanel::hasMoved() const {
    if (!m_start || !m_checkedFrom) {
        return m_start.has_value() != m_checkedFrom.has_value();
    }
    const Twist gone = displacement(m_checkedFrom->pose, m_start->pose);
    return gone.head<3>().norm() > kSamePlace || gone.tail<3>().norm() > kSameAttitude ||
           (m_start->setPoint - m_checkedFrom->setPoint).cwiseAbs().maxCoeff() > kSameSetPoint;
}

void TargetPanel::showEvent(QShowEvent* event) {
    checkTarget();
    QWidget::showEvent(event);
}

void TargetPanel::setTarget(const Pose& pose) {
    const PoseVector si = pose.toVector();
    for (int i = 0; i < 6; ++i) {
        m_fields[static_cast<std::size_t>(i)]->showValue(toDisplay(i, si[i]));
    }
    checkTarget();
}

std::optional<Pose> TargetPanel::target() const {
    PoseVector si;
    for (int i = 0; i < 6; ++i) {
        const auto typed = m_fields[static_cast<std::size_t>(i)]->value();
        if (!typed) {
            return std::nullopt;
        }
        si[i] = fromDisplay(i, *typed);
    }
    return Pose::fromVector(si);
}

void TargetPanel::run() {
    if (const auto pose = target(); pose && runReason().isEmpty()) {
        emit runRequested(*pose, m_ids.take(), m_plan);
    }
}

void TargetPanel::checkTarget() {
    if (m_validity == nullptr || m_fields[5] == nullptr) {
        return;
    }
    m_sinceCheck.start();
    m_checkedFrom = m_start;
    const auto pose = target();
    m_check = pose ? std::optional(m_planner.check(*pose)) : std::nullopt;
    if (m_check && m_check->ok() && m_start && m_hindrance.isEmpty()) {
        plan({*pose, m_mode});
    } else { // there is nothing to plan, or nothing to plan from
        m_planning.cancel();
        m_plan.reset();
        m_waiting = false;
    }
    if (m_named != nullptr) {
        m_named->setTargetWhole(pose.has_value());
    }
    emit targetEdited();
    updateRun();
    showValidity();
    showRanges();
}

/// Beside the screen: until the plan is there, that of before counts only if it is of the same motion.
void TargetPanel::plan(const StraightMove& move) {
    m_check = isPlanned() ? std::optional(m_plan->check) : std::nullopt;
    if (const bool was = std::exchange(m_waiting, !m_check); m_waiting && !was) {
        m_patience.start();
    }
    m_planning.start(
        [planner = m_planner, start = *m_start, move](const Job& job) {
            return std::make_shared<const PlannedMotion>(planner.plan(start, move, planBudget(job)));
        },
        [this](const Job::Outcome<SharedPlan>& outcome) {
            if (!outcome.result) {
                return; // no memory: Run stays disabled until something is edited
            }
            m_plan = *outcome.result;
            m_check = m_plan->check;
            m_waiting = false;
            updateRun();
            showValidity();
        });
}

void TargetPanel::showRanges() {
    for (int i = 0; i < 6; ++i) {
        const NumberField& field = *m_fields[static_cast<std::size_t>(i)];
        QLabel& label = *m_ranges[static_cast<std::size_t>(i)];
        setTone(label, field.isRefused() ? Tone::Bad : Tone::Idle);
        if (field.isRefused()) {
            label.setText(field.refusal());
            continue;
        }
        const auto range = m_start ? axisRange(m_planner, m_start->pose, i) : std::nullopt;
        label.setText(range ? rangeText(*range, i) : ReadOut::dash());
    }
}

void TargetPanel::showValidity() {
    if (const QString refused = refusedField(); !refused.isEmpty()) {
        setTone(*m_lamp, Tone::Bad);
        m_validity->showText(refused);
        return;
    }
    if (!m_hindrance.isEmpty()) {
        setTone(*m_lamp, Tone::Warn);
        m_validity->showText(m_hindrance);
        return;
    }
    if (m_check && m_check->ok() && !m_connected) {
        setTone(*m_lamp, Tone::Idle);
        m_validity->showText(tr("Reachable, but nothing is connected"));
        return;
    }
    if (m_check) {
        setTone(*m_lamp, m_check->ok() ? Tone::Good : Tone::Bad);
        m_validity->showText(motionCheckText(*m_check));
    } else if (!m_patience.isActive()) {
        setTone(*m_lamp, Tone::Idle);
        m_validity->showText(tr("Checking the target"));
    }
}

void TargetPanel::retranslate() {
    const std::array<QString, 6> names = {tr("Target x"),     tr("Target y"),    tr("Target z"),
                                          tr("Target alpha"), tr("Target beta"), tr("Target gamma")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        m_fields[i]->setAccessibleName(names[i]);
        m_fields[i]->setToolTip(coordinateTexts()[i].angle ? tr("Rotation in degrees")
                                                           : tr("Displacement in mm"));
        m_ranges[i]->setToolTip(tr("How far this axis alone can go from the present pose"));
    }
    m_rangeTitle->setText(tr("limits"));
    m_validity->setAccessibleName(tr("Validity"));
    label(*m_run, tr("Run"));
    label(*m_reset, tr("Reset"), tr("Put the home pose into the fields; nothing moves"));
    label(*m_copy, tr("Copy measured"), tr("Put the measured pose into the fields; nothing moves"));
    updateRun();
    showValidity();
    showRanges();
}

void TargetPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_target_panel.cpp"
