// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/machine/control_options.h"
#include "core/record/snapshot.h"
#include "ui/common/motion_ids.h"
#include "ui/common/newest_job.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <array>
#include <optional>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace hexapose {

class NamedPoses;
class NumberField;
class TextReadOut;

/// Where to go: six fields, whether that can be reached and why not, Run and Reset. The motion is planned on
/// a thread of its own, and Run sends the plan of exactly what stands in the fields; until it is there, Run
/// is disabled.
class TargetPanel final : public QWidget {
    Q_OBJECT
public:
    explicit TargetPanel(const SharedModel& model, QWidget* parent = nullptr);

    void setControl(const ControlOptions& options);
    void setConnected(bool connected);
    /// The path that Run will take; checked anew, and nothing moves.
    void setMode(MotionMode mode);
    /// What the present pose and the controller's limits say; checked anew a few times a second at most.
    void showSnapshot(const Snapshot& snapshot);

    void setTarget(const Pose& pose);
    /// Nothing while a field is refused.
    std::optional<Pose> target() const;
    /// Of what stands in the fields; nothing while a field is refused, or the motion is being planned.
    std::optional<MotionCheck> check() const { return m_check; }
    bool isPlanning() const { return m_planning.isRunning(); }
    const std::array<NumberField*, 6>& fields() const { return m_fields; }
    NamedPoses& namedPoses() { return *m_named; }

public slots:
    void run();

signals:
    void runRequested(const hexapose::Pose& target, hexapose::MotionId id, const hexapose::SharedPlan& plan);
    void targetEdited(); ///< or checked anew

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void buildFields(QVBoxLayout& column);
    void buildValidity(QVBoxLayout& column);
    void buildButtons(QVBoxLayout& column);
    void checkTarget();
    void plan(const StraightMove& move);
    bool isPlanned() const;
    bool hasMoved() const;
    void showRanges();
    void showValidity();
    void updateRun();
    QString refusedField() const;
    QString runReason() const;
    void retranslate();

    MotionPlanner m_planner;
    MotionIds m_ids{MotionAsker::Target};
    MotionMode m_mode = MotionMode::Joint;
    QString m_hindrance; ///< why Run cannot be pressed, though something is connected
    bool m_connected = false;
    std::optional<PlanStart> m_start;       ///< present and usable
    std::optional<PlanStart> m_checkedFrom; ///< where it was then
    std::optional<MotionCheck> m_check;
    SharedPlan m_plan;      ///< of what stands in the fields, unless that cannot be reached whatever the path
    bool m_waiting = false; ///< for a plan, without a check
    QTimer m_patience;      ///< until it is over, the planning is not shown
    QElapsedTimer m_sinceCheck;
    std::array<NumberField*, 6> m_fields{};
    std::array<QLabel*, 6> m_ranges{};
    QLabel* m_rangeTitle = nullptr;
    QLabel* m_lamp = nullptr;
    TextReadOut* m_validity = nullptr;
    QPushButton* m_run = nullptr;
    QPushButton* m_reset = nullptr;
    QPushButton* m_copy = nullptr;
    NamedPoses* m_named = nullptr;
    NewestJob m_planning{QStringLiteral("target planning")};
};

} // namespace hexapose
