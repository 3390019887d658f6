// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/machine/control_options.h"
#include "core/record/snapshot.h"
#include "core/session/pose_sequence.h"
#include "ui/common/motion_ids.h"
#include "ui/common/newest_job.h"
#include "ui/console/motion/way_point_table.h"

#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QHBoxLayout;
class QPushButton;

namespace hexapose {

class TextReadOut;

/// A list of poses: played from the first to the last, held on the path, or taken one at a time. It is
/// planned whole before anything moves, on a thread of its own, and each Run sends its plan.
class WayPointsPanel final : public QWidget {
    Q_OBJECT
public:
    explicit WayPointsPanel(const SharedModel& model, QWidget* parent = nullptr);

    void setControl(const ControlOptions& options) {
        m_planner.setSettings(plannerSettings(options, m_planner.model().geometry()));
    }
    void setConnected(bool connected);
    void setMode(MotionMode mode);
    /// Every snapshot: it says when the next pose is due, and why the list ends early.
    void add(const Snapshot& snapshot);
    void showSnapshot(const Snapshot& snapshot);
    /// What "Add target" adds.
    void setTargetSource(std::function<std::optional<Pose>()> target);

    /// From the press on.
    bool isRunning() const { return m_sequence.has_value() || isPlanning(); }
    bool isPlanning() const { return m_planning.isRunning(); }
    /// The list waits, or the loop holds a motion, whoever's it is.
    bool isPaused() const { return m_paused || m_held; }
    /// Ends the list; what moves is stopped by Stop, not by this.
    void stopped(); ///< Stop was pressed
    WayPointTable& table() { return *m_table; }

public slots:
    void updateButtons();
    void play();
    void step();
    void load(const QString& file);
    void save(const QString& file);

signals:
    void runRequested(const hexapose::Pose& target, hexapose::MotionId id, const hexapose::SharedPlan& plan);
    void runAccepted(const hexapose::Pose& target);
    void holdRequested(bool held); ///< the motion, on its path

protected:
    void changeEvent(QEvent* event) override;

private:
    using Text = std::function<QString()>;

    void build();
    void addPose(const std::optional<Pose>& pose);
    QPushButton* addButton(QHBoxLayout& row, int stretch = 1);
    void start(int first, int count);
    void plan();
    void begin(std::vector<SharedPlan> plans);
    void setPaused(bool paused);
    void followHold(const Snapshot& snapshot);
    void requestDue();
    void end(const Text& text);
    int visited() const; ///< row, from 0
    void setMessage(const Text& text);
    void showMessage();
    void followTable();
    void chooseFile(bool toSave);
    void retranslate();

    MotionPlanner m_planner;
    MotionMode m_mode = MotionMode::Joint;
    std::function<std::optional<Pose>()> m_target;
    std::optional<PlanStart> m_from; ///< present and usable
    std::vector<Pose> m_poses;       ///< of the list that is being planned
    std::vector<SharedPlan> m_plans; ///< of the list, as far as they are kept; null once sent
    std::optional<PoseSequence> m_sequence;
    std::optional<WayPointTable::Refusal> m_refusal; ///< of a cell
    MotionIds m_ids{MotionAsker::WayPoints};
    Pose m_asked;              ///< of the last Run
    std::optional<Pose> m_due; ///< the next one, which waits for the end of the pause
    int m_first = 0;           ///< row of the sequence's first pose
    int m_next = 0;            ///< row that Step takes
    bool m_paused = false;     ///< nothing of the list is to move
    bool m_held = false;       ///< the loop holds the motion
    bool m_holdAsked = false;  ///< and has not answered yet
    CommandSet m_allowed;      ///< what the loop would accept
    bool m_connected = false;
    bool m_ready = false; ///< a Run would be taken
    Text m_text;

    WayPointTable* m_table = nullptr;
    QPushButton* m_addMeasured = nullptr;
    QPushButton* m_addTarget = nullptr;
    QPushButton* m_remove = nullptr;
    QPushButton* m_up = nullptr;
    QPushButton* m_down = nullptr;
    QPushButton* m_load = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_play = nullptr;
    QPushButton* m_pause = nullptr;
    QPushButton* m_step = nullptr;
    TextReadOut* m_message = nullptr;
    QTimer m_patience; ///< until it is over, the planning is not shown
    NewestJob m_planning{QStringLiteral("list planning")};
};

} // namespace hexapose
