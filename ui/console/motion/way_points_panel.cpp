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
}

WayPointsPanel::WayPointsPanel(const PlatformGeometry& geometry, QWidget* parent)
    : QWidget(parent), m_planner(makeModel(geometry), plannerSettings({}, geometry)) {
    build();
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
    m_measured = snapshot.stale ? std::nullopt : snapshot.measuredPose;
    m_ready = runInhibit(snapshot).isEmpty() && m_measured.has_value();
    followHold(snapshot);
    updateButtons();
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

/// All of them, one after the other from the present pose; reports the first that cannot be reached.
bool WayPointsPanel::checkRows(int first, int count, std::vector<Pose>& poses) {
    std::optional<Pose> from = m_measured;
    for (int row = first; row < first + count; ++row) {
        const QString number = QString::number(row + 1);
        const auto pose = m_table->poseAt(row);
        if (!pose) {
            return false; // the message has it already
        }
        const MotionCheck check = from ? m_planner.check(*from, *pose, m_mode) : m_planner.check(*pose);
        if (!check.ok()) {
            setMessage([=] { return tr("Row %1: %2. Nothing moved.").arg(number, motionCheckText(check)); });
            m_table->setCurrentCell(row, 0);
            return false;
        }
        poses.push_back(*pose);
        from = pose;
    }
    return true;
}

void WayPointsPanel::start(int first, int count) {
    m_table->finishEditing();
    std::vector<Pose> poses;
    if (isRunning() || m_refusal || !m_connected || !m_ready || count < 1 ||
        !checkRows(first, count, poses)) {
        return;
    }
    m_first = first;
    const MotionId firstId = m_ids.take(poses.size());
    m_sequence.emplace(std::move(poses), kNoDwell, firstId);
    const QString all = QString::number(m_table->rowCount());
    setMessage([this, all] { return tr("To way-point %1 of %2").arg(QString::number(visited() + 1), all); });
    m_table->mark(first);
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
        emit runRequested(m_asked, m_sequence->id());
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
    m_addMeasured->setEnabled(!running && m_measured.has_value());
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
