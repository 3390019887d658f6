// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/jog_hold.h"

#include <utility>

namespace hexapose {

namespace {
constexpr std::chrono::milliseconds kRepeatInterval{50};
constexpr std::chrono::milliseconds kStoodStill{150}; // the loop lets go a little later
} // namespace

JogHold::JogHold(std::function<bool()> mayGoOn, std::function<Clock::time_point()> now, QObject* parent)
    : QObject(parent), m_mayGoOn(std::move(mayGoOn)), m_now(std::move(now)) {
    m_timer.setInterval(kRepeatInterval);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &JogHold::tick);
}

void JogHold::start(const JogDirection& direction) {
    end();
    m_direction = direction;
    m_lastSent = m_now();
    m_timer.start();
    emit held(direction);
}

void JogHold::end() {
    if (!m_direction) {
        return;
    }
    m_direction.reset();
    m_timer.stop();
    emit released();
}

void JogHold::tick() {
    if (!m_direction) {
        return;
    }
    const Clock::time_point now = m_now();
    if (!m_mayGoOn() || now - std::exchange(m_lastSent, now) > kStoodStill) {
        end();
        return;
    }
    emit held(*m_direction);
}

} // namespace hexapose

#include "moc_jog_hold.cpp"
