// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/common/motion_ids.h"
#include "ui/common/newest_job.h"
#include "ui/console/motion/guided_test.h"

#include <QWidget>

#include <array>
#include <functional>
#include <memory>
#include <optional>

class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace hexapose {

class ReadOut;
class TextReadOut;

/// The published physical test as one button: its steps while they happen, and what came out.
class GuidedTestPanel final : public QWidget {
    Q_OBJECT
public:
    explicit GuidedTestPanel(const SharedModel& model, QWidget* parent = nullptr);

    void setControl(const ControlOptions& options) {
        m_planner.setSettings(plannerSettings(options, m_planner.model().geometry()));
    }
    void setSolver(std::shared_ptr<const ForwardSolver> solver);
    void setConnected(bool connected);
    void setMode(MotionMode mode);
    /// Every snapshot.
    void add(const Snapshot& snapshot);
    void showSnapshot(const Snapshot& snapshot);

    /// From the press on, when the way there is planned on a thread of its own.
    bool isRunning() const { return !m_ended; }
    bool isPlanning() const { return m_planning.isRunning(); }
    void stopped(); ///< Stop was pressed

public slots:
    void start();

signals:
    void runRequested(const hexapose::Pose& target, hexapose::MotionId id, const hexapose::SharedPlan& plan);
    void runAccepted(const hexapose::Pose& target);

protected:
    void changeEvent(QEvent* event) override;

private:
    using Text = std::function<QString()>;
    struct Row {
        ReadOut* target;
        ReadOut* measured;
        ReadOut* error;
        ReadOut* expected;
    };
    static constexpr int kSteps = 4;

    void buildSteps(QVBoxLayout& column);
    void buildResult(QVBoxLayout& column);
    void addRow(QGridLayout& grid, int coordinate);
    void plan();
    void begin(const SharedPlan& plan);
    void end(const Text& text);
    void setMessage(const Text& text);
    void showSteps();
    void showResult();
    void updateButton();
    void retranslate();

    MotionPlanner m_planner;
    MotionIds m_ids{MotionAsker::GuidedTest};
    std::shared_ptr<const ForwardSolver> m_solver;
    MotionMode m_mode = MotionMode::Joint;
    std::optional<PlanStart> m_from; ///< present and usable
    SharedPlan m_plan;               ///< of the test's Run
    std::optional<GuidedTest> m_test;
    std::optional<GuidedTest> m_shown; ///< the last one that moved the platform
    bool m_ended = true;               ///< no test, or one that is over
    bool m_connected = false;
    bool m_ready = false; ///< a Run would be taken
    Text m_text;

    QPushButton* m_start = nullptr;
    std::array<QLabel*, kSteps> m_lamps{};
    std::array<QLabel*, kSteps> m_stepTexts{};
    std::array<QLabel*, 4> m_heads{};
    std::array<Row, 6> m_rows{};
    QLabel* m_lengthsTitle = nullptr;
    std::array<ReadOut*, 6> m_lengths{};
    TextReadOut* m_message = nullptr;
    NewestJob m_planning{QStringLiteral("test planning")};
};

} // namespace hexapose
