// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/way_points_panel.h"

#include "core/base/input_error.h"
#include "core/record/pose_list.h"
#include "ui/common/read_out.h"
#include "ui/common/status_text.h"
#include "ui/console/events/input_fault_text.h"
#include "ui/console/events/motion_check_text.h"
#include "ui/console/events/sequence_end_text.h"
#include "ui/console/motion/plan_start.h"
#include "ui/console/motion/way_point_file.h"
#include "ui/console/motion/way_point_table.h"

#include <QEvent>
#include <QFileInfo>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <utility>

// What the way-points do; way_points_layout.cpp is how they look and what they say.
namespace hexapose {

namespace {
constexpr std::chrono::nanoseconds kNoDwell{0}; // it has settled; there is nothing to wait for
constexpr int kPatienceMs = 200;
/// One in workspace mode may hold 150 kB; those after these are made once more, by the loop.
constexpr std::size_t kKeptPlans = 200;
} // namespace

WayPointsPanel::WayPointsPanel(const SharedModel& model, QWidget* parent)
    : QWidget(parent), m_planner(model, plannerSettings({}, model->geometry())) {
    build();
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatienceMs);
    connect(&m_patience, &QTimer::timeout, this,
            [this] { setMessage([] { return tr("Checking the list; Stop ends it"); }); });
    m_text = [] { return tr("Add poses, or load them; nothing moves until Play or Step"); };
    retranslate();
    updateButtons();
}

void WayPointsPanel::setConnected(bool connected) {
    m_connected = connected;
    if (!connected && isRunning()) {
        const QString row = QString::number(visited() + 1);
        end([row] { return tr("Ended at way-point %1: the connection was closed").arg(row); });
    }
    updateButtons();
}

void WayPointsPanel::showSnapshot(const Snapshot& snapshot) {
    m_planner.setControllerLimits(snapshot.minLength, snapshot.maxLength);
    m_from = planStart(snapshot);
    m_ready = runInhibit(snapshot).isEmpty() && m_from.has_value();
    followHold(snapshot);
    updateButtons();
}

void WayPointsPanel::setMode(MotionMode mode) {
    m_mode = mode;
    if (isPlanning() && m_from) {
        plan();
    }
}

void WayPointsPanel::setTargetSource(std::function<std::optional<Pose>()> target) {
    m_target = std::move(target);
    updateButtons();
}

void WayPointsPanel::addPose(const std::optional<Pose>& pose) {
    if (pose) {
        m_table->append(*pose);
    }
}

int WayPointsPanel::visited() const {
    const int last = m_sequence ? static_cast<int>(m_sequence->count()) - 1 : 0;
    return m_first + (m_sequence ? std::min(static_cast<int>(m_sequence->finished()), last) : 0);
}

void WayPointsPanel::play() {
    start(0, m_table->rowCount());
}

void WayPointsPanel::step() {
    start(m_next < m_table->rowCount() ? m_next : 0, 1);
}

void WayPointsPanel::start(int first, int count) {
    m_table->finishEditing();
    if (isRunning() || m_refusal || !m_connected || !m_ready || count < 1) {
        return;
    }
    m_first = first;
    m_poses.clear();
    for (int row = first; row < first + count; ++row) {
        m_poses.push_back(m_table->poseAt(row).value_or(Pose{})); // whole: no cell is refused
    }
    m_patience.start();
    plan();
    updateButtons();
}

/// All of them, one after the other from where the platform is, up to the first that cannot be reached.
void WayPointsPanel::plan() {
    m_planning.start(
        [planner = m_planner, from = *m_from, poses = m_poses, mode = m_mode](const Job& job) {
            std::vector<SharedPlan> plans;
            PlanStart start = from;
            for (const Pose& pose : poses) {
                PlannedMotion planned = planner.plan(start, StraightMove{pose, mode}, planBudget(job));
                start = {planned.endLengths, pose};
                if (plans.size() >= kKeptPlans) {
                    planned.motion.reset();
                }
                plans.push_back(std::make_shared<const PlannedMotion>(std::move(planned)));
                if (!plans.back()->check.ok() || job.isCancelled()) {
                    break;
                }
            }
            return plans;
        },
        [this](const Job::Outcome<std::vector<SharedPlan>>& outcome) {
            begin(outcome.result.value_or(std::vector<SharedPlan>()));
        });
}

void WayPointsPanel::begin(std::vector<SharedPlan> plans) {
    m_patience.stop();
    const auto row = m_first + static_cast<int>(plans.size()) - 1;
    if (!plans.empty() && !plans.back()->check.ok()) {
        const QString number = QString::number(row + 1);
        const MotionCheck check = plans.back()->check;
        m_table->setCurrentCell(row, 0);
        end([=] { return tr("Row %1: %2. Nothing moved.").arg(number, motionCheckText(check)); });
        return;
    }
    if (plans.empty() || !m_ready) { // any more
        end([] { return tr("The platform is not ready any more. Nothing moved."); });
        return;
    }
    const MotionId firstId = m_ids.take(m_poses.size());
    m_plans = std::move(plans);
    m_plans.resize(std::min(m_plans.size(), kKeptPlans));
    m_sequence.emplace(std::move(m_poses), kNoDwell, firstId);
    const QString all = QString::number(m_table->rowCount());
    setMessage([this, all] { return tr("To way-point %1 of %2").arg(QString::number(visited() + 1), all); });
    m_table->mark(m_first);
    updateButtons();
}

void WayPointsPanel::add(const Snapshot& snapshot) {
    if (!m_sequence) {
        return;
    }
    const std::size_t accepted = m_sequence->accepted();
    const auto next = m_sequence->add(snapshot);
    if (m_sequence->accepted() > accepted) {
        emit runAccepted(m_asked);
    }
    const PoseSequence::Phase phase = m_sequence->phase();
    if (phase == PoseSequence::Phase::Failed) {
        const QString row = QString::number(visited() + 1);
        end([row, failed = *m_sequence] {
            return tr("Ended at way-point %1: %2").arg(row, sequenceEndText(failed));
        });
    } else if (phase == PoseSequence::Phase::Done) {
        const auto done = static_cast<int>(m_sequence->count());
        const QString row = QString::number(m_first + done);
        m_next = (m_first + done) % std::max(m_table->rowCount(), 1);
        end(done > 1 ? Text([done] { return tr("All %1 way-points visited").arg(done); })
                     : Text([row] { return tr("At way-point %1").arg(row); }));
    } else {
        m_table->mark(visited());
        showMessage();
        if (next) {
            m_due = next;
            requestDue();
        }
    }
}

void WayPointsPanel::stopped() {
    if (isRunning()) {
        const QString row = QString::number(visited() + 1);
        end([row] {
            return tr("Stopped while moving to way-point %1. Press Clear, then Play or Step.").arg(row);
        });
    }
}

void WayPointsPanel::end(const Text& text) {
    if (m_sequence && m_sequence->phase() != PoseSequence::Phase::Done) {
        m_next = visited(); // Step tries it again
    }
    m_planning.cancel();
    m_patience.stop();
    m_plans.clear();
    m_sequence.reset();
    m_due.reset();
    m_paused = false; // what the loop holds it goes on to hold
    m_table->mark(-1);
    setMessage(text);
    updateButtons();
}

/// A motion is held by the loop; between two motions the list waits by itself.
void WayPointsPanel::setPaused(bool paused) {
    m_paused = paused && isRunning();
    if (m_allowed.contains(paused ? Command::Hold : Command::Resume)) {
        m_held = m_holdAsked = paused;
        emit holdRequested(paused);
    }
    requestDue();
    updateButtons();
}

void WayPointsPanel::followHold(const Snapshot& snapshot) {
    m_allowed = snapshot.allowed;
    const bool may = m_allowed.contains(Command::Hold);
    m_holdAsked = m_holdAsked && may;
    m_held = snapshot.held || m_holdAsked;
    // A motion of the list that was asked for before the pause, and begins in it.
    if (m_paused && may && !m_holdAsked) {
        setPaused(true);
    }
}

void WayPointsPanel::requestDue() {
    if (m_due && !m_paused) {
        m_asked = *std::exchange(m_due, std::nullopt);
        const std::size_t at = m_sequence->finished();
        const SharedPlan plan = at < m_plans.size() ? std::exchange(m_plans[at], nullptr) : nullptr;
        emit runRequested(m_asked, m_sequence->id(), plan);
    }
}

void WayPointsPanel::setMessage(const Text& text) {
    m_text = text;
    showMessage();
}

void WayPointsPanel::load(const QString& file) {
    if (isRunning()) {
        return;
    }
    try {
        const std::vector<Pose> poses = readPoseList(file.toStdString());
        m_table->setPoses(poses);
        m_next = 0;
        const QString name = QFileInfo(file).fileName();
        const auto count = poses.size();
        setMessage([=] { return tr("%1 way-points from %2").arg(QString::number(count), name); });
    } catch (const InputError& error) {
        setMessage([error] { return tr("The list cannot be used: %1").arg(inputFaultText(error)); });
    }
}

void WayPointsPanel::save(const QString& file) {
    m_table->finishEditing();
    if (m_refusal) {
        return; // the message has it already
    }
    std::vector<Pose> poses;
    poses.reserve(static_cast<std::size_t>(m_table->rowCount()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        poses.push_back(m_table->poseAt(row).value_or(Pose{}));
    }
    const QString fault = saveWayPoints(file, poses);
    setMessage([=] {
        return fault.isEmpty() ? tr("Saved as %1").arg(file) : tr("The list cannot be saved: %1").arg(fault);
    });
}

/// The latest message; while a cell is refused, its refusal.
void WayPointsPanel::showMessage() {
    m_message->showText(
        m_refusal ? tr("Row %1: %2: %3")
                        .arg(QString::number(m_refusal->row + 1),
                             coordinateTexts()[static_cast<std::size_t>(m_refusal->coordinate)].symbol,
                             m_refusal->reason)
                  : m_text());
}

void WayPointsPanel::followTable() {
    m_refusal = m_table->refusal();
    showMessage();
    updateButtons();
}

void WayPointsPanel::updateButtons() {
    const bool running = isRunning();
    const int rows = m_table->rowCount();
    const int at = m_table->currentRow();
    m_table->setEditable(!running);
    m_addMeasured->setEnabled(!running && m_from.has_value());
    const bool targetWhole = m_target && m_target();
    m_addTarget->setEnabled(!running && targetWhole);
    m_addTarget->setToolTip(targetWhole ? tr("Add the pose of the target's fields; nothing moves")
                                        : tr("A field of the target is refused"));
    m_load->setEnabled(!running);
    m_save->setEnabled(!running && rows > 0 && !m_refusal);
    m_remove->setEnabled(!running && at >= 0);
    m_up->setEnabled(!running && at > 0);
    m_down->setEnabled(!running && at >= 0 && at < rows - 1);
    const bool startable = !running && rows > 0 && m_connected && m_ready && !m_refusal;
    m_play->setEnabled(startable);
    m_step->setEnabled(startable);
    m_pause->setEnabled(running || isPaused() || m_allowed.contains(Command::Hold));
    const QSignalBlocker quiet(m_pause);
    m_pause->setChecked(isPaused());
}

void WayPointsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_way_points_panel.cpp"
