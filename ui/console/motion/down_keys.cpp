// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/down_keys.h"

#include <QTimer>

#include <chrono>

namespace hexapose {

namespace {
constexpr std::chrono::milliseconds kNoPressWithin{20};
}

void DownKeys::release(int key) {
    const int number = ++m_releases;
    m_keys[key] = number;
    QTimer::singleShot(kNoPressWithin, Qt::PreciseTimer, this, [this, key, number] {
        if (m_keys.value(key, kDown) == number) {
            m_keys.remove(key);
            emit up(key);
        }
    });
}

} // namespace hexapose

#include "moc_down_keys.cpp"
