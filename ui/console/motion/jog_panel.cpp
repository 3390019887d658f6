// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/jog_panel.h"

#include "ui/common/read_out.h"
#include "ui/common/status_text.h"
#include "ui/console/motion/axis_range.h"
#include "ui/console/motion/jog_keys.h"

#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QPushButton>

#include <algorithm>

// What the jog panel does; jog_panel_layout.cpp is how it looks and what it says.
namespace hexapose {

namespace {

/// Some desktops repeat a held key as a release and a press that nothing marks, at once or a little apart: a
/// release counts when no press has followed by then. Nobody presses a key again as fast.
constexpr std::chrono::milliseconds kKeyUp{20};

/// Events after which a jog that is held does not come about.
bool endsTheJog(EventCode code) {
    return code == EventCode::MoveRefused || code == EventCode::CommandRefused;
}

bool drivesOn(RunState state) {
    return state == RunState::Enabled || state == RunState::Moving || state == RunState::Settling;
}

} // namespace

JogPanel::JogPanel(const PlatformGeometry& geometry, QWidget* parent,
                   std::function<JogHold::Clock::time_point()> now)
    : QWidget(parent), m_judge(geometry), m_hold([this] { return mayGoOn(); }, std::move(now)) {
    build();
    connect(&m_hold, &JogHold::held, this, &JogPanel::jogRequested);
    connect(&m_hold, &JogHold::released, this, [this] {
        if (m_heldByKey) {
            std::for_each(m_buttons.begin(), m_buttons.end(), [](QPushButton* one) { one->setDown(false); });
        }
        m_heldByKey = false;
        m_heldButton = nullptr;
        emit releaseRequested();
    });
    m_keyUp.setSingleShot(true);
    m_keyUp.setInterval(kKeyUp);
    m_keyUp.setTimerType(Qt::PreciseTimer);
    connect(&m_keyUp, &QTimer::timeout, this, [this] {
        m_downKey = 0;
        if (m_heldByKey) {
            m_hold.end();
        }
    });
    retranslate();
    updateButtons();
}

void JogPanel::setConnected(bool connected) {
    if (connected != m_connected) {
        m_connected = connected;
        m_sinceRanges.invalidate();
        showRanges();
        updateButtons();
    }
}

void JogPanel::add(const Snapshot& snapshot) {
    for (const Event& event : snapshot.events) {
        m_jogging = m_jogging || event.code == EventCode::JogStarted;
        if (endsTheJog(event.code)) {
            m_hold.end();
        }
    }
    if (snapshot.state != RunState::Moving) {
        m_jogging = false;
    }
}

void JogPanel::showSnapshot(const Snapshot& snapshot) {
    const bool changed = snapshot.state != m_latest.state || snapshot.stale != m_latest.stale ||
                         snapshot.link != m_latest.link;
    m_latest = snapshot;
    m_judge.follow(snapshot);
    if (changed) {
        updateButtons();
    }
    showRanges();
}

JogDirection JogPanel::directionOf(int axis, bool up) const {
    return {axis, up, m_frame->currentIndex() == 1 ? JogFrame::Platform : JogFrame::Base};
}

std::optional<double> JogPanel::step(int axis) const {
    const double shown = m_step->currentData().toDouble();
    return shown > 0.0 ? std::optional(fromDisplay(axis, shown)) : std::nullopt;
}

bool JogPanel::canHold() const {
    return m_connected && !m_latest.stale && m_latest.measuredPose &&
           (m_latest.state == RunState::Enabled || m_latest.state == RunState::Settling ||
            (m_latest.state == RunState::Moving && m_jogging));
}

/// Asked before each repetition, besides the events that end a jog at once.
bool JogPanel::mayGoOn() const {
    return isVisible() && !window()->isMinimized() && QApplication::activePopupWidget() == nullptr &&
           m_connected && !m_latest.stale && drivesOn(m_latest.state) &&
           (m_heldButton == nullptr || m_heldButton->isDown());
}

void JogPanel::press(const JogDirection& direction) {
    if (canHold()) {
        m_hold.start(direction);
    }
}

void JogPanel::takeStep(const JogDirection& direction) {
    const bool stands = m_latest.state == RunState::Enabled || m_latest.state == RunState::Settling;
    const auto size = step(direction.axis);
    if (!size || !stands || !canHold()) {
        return;
    }
    // From where it was sent, so that steps add up; after a jog or a stop from where it is.
    emit stepRequested(stepped(m_latest.goalPose.value_or(*m_latest.measuredPose), direction, *size));
}

/// The direction that a key means there: space that of the button with the focus.
std::optional<JogDirection> JogPanel::directionOfKey(const QObject* at, const QKeyEvent& key) const {
    const auto found = std::find(m_buttons.begin(), m_buttons.end(), at);
    if (key.key() == Qt::Key_Space && found != m_buttons.end()) {
        const auto index = static_cast<int>(found - m_buttons.begin());
        return directionOf(index / 2, index % 2 == 1);
    }
    const auto way = jogKey(key.key(), key.modifiers());
    return way ? std::optional(directionOf(way->first, way->second)) : std::nullopt;
}

bool JogPanel::keyPressed(const QObject* at, const QKeyEvent& key) {
    const auto direction = directionOfKey(at, key);
    if (key.isAutoRepeat() || key.key() == m_downKey) {
        m_keyUp.stop(); // the keyboard repeats, the hand does not
        return direction.has_value();
    }
    if (m_hold.direction()) {
        m_hold.end(); // a second key beside what is held leaves it unclear what is meant
        return key.key() != Qt::Key_Escape;
    }
    if (!direction) {
        return false;
    }
    m_keyUp.stop();
    m_downKey = key.key();
    if (step(direction->axis)) {
        takeStep(*direction);
    } else {
        press(*direction);
        m_heldByKey = m_hold.direction().has_value();
        button(direction->axis, direction->up)->setDown(m_heldByKey);
    }
    return true;
}

bool JogPanel::keyReleased(const QKeyEvent& key) {
    if (m_heldByKey && key.key() == Qt::Key_Shift) {
        m_hold.end();
        return true;
    }
    if (key.key() != m_downKey) {
        return false;
    }
    if (!key.isAutoRepeat()) {
        m_keyUp.start();
    }
    return true;
}

bool JogPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && keyPressed(watched, *static_cast<QKeyEvent*>(event))) {
        return true;
    }
    if (event->type() == QEvent::KeyRelease && keyReleased(*static_cast<QKeyEvent*>(event))) {
        return true;
    }
    if (event->type() == QEvent::FocusOut) { // to another widget, another window or a popup
        m_hold.end();
    }
    return QWidget::eventFilter(watched, event);
}

bool JogPanel::event(QEvent* event) {
    if (event->type() == QEvent::WindowDeactivate) {
        m_hold.end();
    }
    return QWidget::event(event);
}

void JogPanel::hideEvent(QHideEvent* event) {
    m_hold.end();
    QWidget::hideEvent(event);
}

void JogPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_sinceRanges.invalidate();
    showRanges();
}

void JogPanel::updateButtons() {
    const bool on = hindrance().isEmpty();
    if (!on) {
        m_hold.end();
    }
    for (QPushButton* button : m_buttons) {
        button->setEnabled(on);
    }
    showHint();
}

} // namespace hexapose
