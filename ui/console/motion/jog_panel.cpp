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
#include <QMouseEvent>
#include <QPushButton>

#include <algorithm>
#include <utility>

// What the jog panel does; jog_panel_layout.cpp is how it looks and what it says.
namespace hexapose {

namespace {

/// Events after which a jog that is held does not come about.
bool endsTheJog(EventCode code) {
    return code == EventCode::MoveRefused || code == EventCode::CommandRefused ||
           code == EventCode::PreparationFailed;
}

} // namespace

JogPanel::JogPanel(const SharedModel& model, QWidget* parent, std::function<JogHold::Clock::time_point()> now)
    : QWidget(parent), m_planner(model, plannerSettings({}, model->geometry())),
      m_hold([this] { return mayGoOn(); }, std::move(now)) {
    build();
    connect(&m_hold, &JogHold::held, this, [this](const JogDirection& direction) {
        // While the jog before comes to rest this one waits, as long as its button is held.
        if (m_latest.motionId == m_jogId || m_latest.allowed.contains(Command::Jog)) {
            emit jogRequested(direction, m_jogId);
        }
    });
    connect(&m_hold, &JogHold::released, this, [this] {
        if (m_heldByKey) {
            std::for_each(m_buttons.begin(), m_buttons.end(), [](QPushButton* one) { one->setDown(false); });
        }
        m_heldByKey = false;
        m_heldButton = nullptr;
        emit releaseRequested();
    });
    connect(&m_keys, &DownKeys::up, this, [this] {
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
        if (endsTheJog(event.code)) {
            m_hold.end();
            m_stepAsked = false;
        }
    }
    const bool moving = snapshot.state == RunState::Moving;
    m_jogging = moving && isMotionOf(MotionAsker::Jog, snapshot.motionId);
    m_stepping = moving && isMotionOf(MotionAsker::JogStep, snapshot.motionId);
    m_stepAsked = m_stepAsked && snapshot.motionId != m_stepId && drivesAreOn(snapshot.state);
}

void JogPanel::showSnapshot(const Snapshot& snapshot) {
    m_latest = snapshot;
    m_planner.setControllerLimits(snapshot.minLength, snapshot.maxLength);
    if (hindrance() != m_hindrance) {
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
           (m_latest.allowed.contains(Command::Jog) || m_jogging);
}

/// Asked before each repetition, besides the events that end a jog at once.
bool JogPanel::mayGoOn() const {
    return isVisible() && !window()->isMinimized() && QApplication::activePopupWidget() == nullptr &&
           m_connected && !m_latest.stale && drivesAreOn(m_latest.state) &&
           (m_heldButton == nullptr || m_heldButton->isDown());
}

void JogPanel::press(const JogDirection& direction) {
    if (canHold()) {
        m_jogId = m_jogIds.take();
        m_hold.start(direction);
    }
}

void JogPanel::takeStep(const JogDirection& direction) {
    const auto size = step(direction.axis);
    if (!size || !m_keys.isEmpty() || !m_latest.measuredPose || !hindrance().isEmpty()) {
        return;
    }
    m_tooSoon = m_stepAsked || m_latest.state == RunState::Moving;
    showHint();
    if (m_tooSoon) {
        return;
    }
    m_stepAsked = true;
    // From where it was sent, so that steps add up; after a jog or a stop from where it is.
    m_stepId = m_stepIds.take();
    emit stepRequested(stepped(m_latest.goalPose.value_or(*m_latest.measuredPose), direction, *size),
                       m_stepId);
}

/// The direction that a key means there: space that of the button with the focus.
std::optional<JogDirection> JogPanel::directionOfKey(const QObject* at, const QKeyEvent& key) const {
    const auto found = std::find(m_buttons.begin(), m_buttons.end(), at);
    if (key.key() == Qt::Key_Space && found != m_buttons.end()) {
        const auto index = static_cast<int>(found - m_buttons.begin());
        return directionOf(index / 2, index % 2 == 1);
    }
    const auto jog = jogKey(key.key(), key.modifiers());
    return jog ? std::optional(directionOf(jog->first, jog->second)) : std::nullopt;
}

bool JogPanel::keyPressed(const QObject* at, const QKeyEvent& key) {
    const auto direction = directionOfKey(at, key);
    if (key.isAutoRepeat() || m_keys.contains(key.key())) { // the keyboard repeats, the hand does not
        if (direction) {
            m_keys.press(key.key());
        }
        return direction.has_value();
    }
    const bool second = !m_keys.isEmpty() || m_mouseDown || m_hold.direction();
    if (!direction && !m_hold.direction()) {
        return false;
    }
    if (second) {
        m_hold.end(); // beside what is held it is not clear what is meant
        m_keys.press(key.key());
        return key.key() != Qt::Key_Escape;
    }
    if (step(direction->axis)) {
        takeStep(*direction);
    } else {
        press(*direction);
        m_heldByKey = m_hold.direction().has_value();
        button(direction->axis, direction->up)->setDown(m_heldByKey);
    }
    m_keys.press(key.key());
    return true;
}

bool JogPanel::keyReleased(const QObject* at, const QKeyEvent& key) {
    if (key.isAutoRepeat()) {
        return m_keys.contains(key.key());
    }
    const bool known = m_keys.contains(key.key());
    // Held since before the focus came: the press that may follow is none.
    if (known || directionOfKey(at, key)) {
        m_keys.release(key.key());
    }
    if (m_heldByKey && key.key() == Qt::Key_Shift) {
        m_hold.end();
        return true;
    }
    return known;
}

void JogPanel::mouseEvent(const QEvent& event) {
    if (static_cast<const QMouseEvent&>(event).button() == Qt::LeftButton) {
        m_mouseDown = event.type() != QEvent::MouseButtonRelease;
        m_mouseUsed = false;
    }
}

/// Qt says it again when the pointer comes back to the button, without a new press.
void JogPanel::buttonPressed(QPushButton* made, const JogDirection& direction) {
    if (step(direction.axis) || (m_mouseDown && std::exchange(m_mouseUsed, true))) {
        return;
    }
    if (!m_keys.isEmpty() || m_hold.direction()) {
        m_hold.end();
        return;
    }
    press(direction);
    m_heldButton = m_hold.direction() ? made : nullptr;
}

void JogPanel::focusLost() {
    m_hold.end();
    const QWidget* now = QApplication::focusWidget();
    if (now == nullptr || (now != m_pad && !m_pad->isAncestorOf(now))) {
        m_keys.clear(); // their releases go elsewhere
    }
}

bool JogPanel::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::KeyPress:
        return keyPressed(watched, *static_cast<QKeyEvent*>(event));
    case QEvent::KeyRelease:
        return keyReleased(watched, *static_cast<QKeyEvent*>(event));
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonRelease:
        if (watched != m_pad) {
            mouseEvent(*event);
        }
        break;
    case QEvent::FocusOut: // to another widget, another window or a popup
        focusLost();
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

bool JogPanel::event(QEvent* event) {
    if (event->type() == QEvent::WindowDeactivate) {
        m_hold.end();
        m_keys.clear();
    }
    return QWidget::event(event);
}

void JogPanel::hideEvent(QHideEvent* event) {
    m_hold.end();
    m_keys.clear();
    QWidget::hideEvent(event);
}

void JogPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_sinceRanges.invalidate();
    showRanges();
}

void JogPanel::updateButtons() {
    m_hindrance = hindrance();
    const bool on = m_hindrance.isEmpty();
    if (!on) {
        m_hold.end();
        // Qt would hand the focus of a disabled button on, and the next key might press what gets it.
        if (const QWidget* focused = QApplication::focusWidget();
            focused != nullptr && focused != m_pad && m_pad->isAncestorOf(focused)) {
            m_pad->setFocus();
        }
    }
    for (QPushButton* button : m_buttons) {
        button->setEnabled(on);
    }
    showHint();
}

} // namespace hexapose

#include "moc_jog_panel.cpp"
