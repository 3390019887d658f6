// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/motion/jog.h"

#include <QObject>
#include <QTimer>

#include <chrono>
#include <functional>
#include <optional>

namespace hexapose {

/// Hold-to-run: while a direction is held it is repeated every 50 ms, and its end is sent at once. What may
/// not go on ends by itself at the next repetition, and so does what could not be repeated in time: after a
/// screen that stood still the button has to be pressed anew.
class JogHold final : public QObject {
    Q_OBJECT
public:
    using Clock = std::chrono::steady_clock;

    /// mayGoOn: asked before each repetition.
    explicit JogHold(std::function<bool()> mayGoOn, std::function<Clock::time_point()> now = Clock::now,
                     QObject* parent = nullptr);

    /// Another direction than the one that is held ends that first.
    void start(const JogDirection& direction);
    void end();
    const std::optional<JogDirection>& direction() const { return m_direction; }
    /// The timer calls it, and so may a test.
    void tick();

signals:
    void held(const hexapose::JogDirection& direction);
    void released();

private:
    std::function<bool()> m_mayGoOn;
    std::function<Clock::time_point()> m_now;
    std::optional<JogDirection> m_direction;
    Clock::time_point m_lastSent{};
    QTimer m_timer;
};

} // namespace hexapose
