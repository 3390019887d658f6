// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/machine/control_options.h"
#include "core/motion/jog.h"
#include "core/record/snapshot.h"
#include "ui/common/motion_ids.h"
#include "ui/console/motion/down_keys.h"
#include "ui/console/motion/jog_hold.h"

#include <QElapsedTimer>
#include <QWidget>

#include <array>
#include <optional>

class QComboBox;
class QGridLayout;
class QKeyEvent;
class QLabel;
class QPushButton;

namespace hexapose {

class TextReadOut;

/// Twelve buttons that move the platform along and about the axes: as long as one is held, or one step per
/// click. Let go, out of focus, out of sight, behind a popup or in a window that is not in front: released at
/// once. One press is one jog: a second key or button ends it, and nothing starts before all of them are up.
class JogPanel final : public QWidget {
    Q_OBJECT
public:
    explicit JogPanel(const SharedModel& model, QWidget* parent = nullptr,
                      std::function<JogHold::Clock::time_point()> now = JogHold::Clock::now);

    void setControl(const ControlOptions& options) {
        m_planner.setSettings(plannerSettings(options, m_planner.model().geometry()));
    }
    void setConnected(bool connected);
    /// Every snapshot: its events end a jog that the loop does not carry out.
    void add(const Snapshot& snapshot);
    /// The latest one, for what is shown.
    void showSnapshot(const Snapshot& snapshot);
    void release() { m_hold.end(); }
    JogHold& hold() { return m_hold; }
    /// No key and no button is down, so that the next press can start a jog.
    bool isAllUp() const { return m_keys.isEmpty() && !m_mouseDown; }

signals:
    void jogRequested(const hexapose::JogDirection& direction, hexapose::MotionId id);
    void releaseRequested();
    void stepRequested(const hexapose::Pose& target, hexapose::MotionId id);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool event(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// Of one direction in the arrays of buttons and ranges.
    static std::size_t slot(int axis, bool up) { return 2 * static_cast<std::size_t>(axis) + (up ? 1U : 0U); }
    void build();
    void addRow(QGridLayout& grid, int axis);
    QPushButton*& button(int axis, bool up) { return m_buttons[slot(axis, up)]; }
    JogDirection directionOf(int axis, bool up) const;
    std::optional<double> step(int axis) const; ///< m or rad; nothing: hold
    bool canHold() const;
    bool mayGoOn() const;
    void press(const JogDirection& direction);
    void takeStep(const JogDirection& direction);
    std::optional<JogDirection> directionOfKey(const QObject* at, const QKeyEvent& key) const;
    bool keyPressed(const QObject* at, const QKeyEvent& key);
    bool keyReleased(const QObject* at, const QKeyEvent& key);
    void mouseEvent(const QEvent& event);
    void focusLost();
    void buttonPressed(QPushButton* made, const JogDirection& direction);
    void showRanges();
    QString hindrance() const;
    void showHint();
    void updateButtons();
    void retranslate();

    MotionPlanner m_planner;
    JogHold m_hold;
    Snapshot m_latest;
    QString m_hindrance; ///< that the buttons show
    bool m_connected = false;
    MotionIds m_jogIds{MotionAsker::Jog};
    MotionIds m_stepIds{MotionAsker::JogStep};
    MotionId m_jogId = kNoMotion;  ///< of the present or last press
    MotionId m_stepId = kNoMotion; ///< of the last step
    bool m_jogging = false;        ///< what moves is a jog of ours
    bool m_stepAsked = false;      ///< a step was asked for, and no answer has come yet
    bool m_stepping = false;       ///< what moves is a step of ours
    bool m_tooSoon = false;        ///< the last step was asked for while another was under way
    bool m_heldByKey = false;      ///< and not by the mouse
    DownKeys m_keys;               ///< on the pad
    bool m_mouseDown = false;      ///< on a button, or with the pointer moved off it
    bool m_mouseUsed = false;      ///< that press has started its jog
    QPushButton* m_heldButton = nullptr;
    QElapsedTimer m_sinceRanges;
    QLabel* m_frameLabel = nullptr;
    QComboBox* m_frame = nullptr;
    QLabel* m_stepLabel = nullptr;
    QComboBox* m_step = nullptr;
    QWidget* m_pad = nullptr; ///< where the keys count
    std::array<QPushButton*, 12> m_buttons{};
    std::array<QLabel*, 12> m_ranges{};
    std::array<QLabel*, 2> m_rangeHeads{};
    TextReadOut* m_hint = nullptr;
};

} // namespace hexapose
