// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/row_choice.h"

#include <utility>

namespace hexapose {

namespace {

constexpr std::chrono::milliseconds kRowInterval{100};
/// A settled pose is averaged over a second of measurements, which begins after the motion.
constexpr std::chrono::milliseconds kActiveFor{1500};
constexpr double kMoves = 1.5e-4;       ///< m; lengths that flicker between steps of 0.1 mm do not move
constexpr std::size_t kMostKept = 1000; ///< rows: 100 ms at 10 kHz

} // namespace

RowChoice::RowChoice() {
    m_keptBack.reserve(kMostKept + 1);
    m_due.reserve(kMostKept + 1);
}

RowChoice::Setting RowChoice::settingOf(const Snapshot& s) {
    return {s.state, s.link,     s.controllerState, s.stale,           s.held,
            s.mode,  s.motionId, s.speed,           s.commandedLengths};
}

bool RowChoice::happens(const Snapshot& s) {
    Setting setting = settingOf(s);
    bool happens = isInMotion(s.state) || !s.events.empty() || m_setting != setting;
    m_setting = std::move(setting);
    if (!s.fresh || !s.measuredLengths)
        return happens;
    happens = happens || m_status != s.status || !m_lengths ||
              (*m_lengths - *s.measuredLengths).cwiseAbs().maxCoeff() > kMoves;
    m_status = s.status;
    if (happens)
        m_lengths = s.measuredLengths;
    return happens;
}

bool RowChoice::isDue(const Snapshot& s) const {
    const auto since = s.time - m_lastRow;
    if (m_state != s.state || !s.events.empty())
        return true;
    if (!m_isAtRest)
        return s.fresh || since >= kRowInterval;
    // A row with a measurement says more; where they are rare the interval does not wait for them.
    return since >= kRowInterval && (s.fresh || s.stale || since >= 2 * kRowInterval);
}

std::span<const RowChoice::SnapshotPtr> RowChoice::add(const SnapshotPtr& snapshot) {
    const Snapshot& s = *snapshot;
    m_due.clear();
    const bool happensNow = happens(s);
    if (happensNow) {
        m_happened = s.time;
        std::swap(m_due, m_keptBack);
    }
    m_isAtRest = s.time - m_happened >= kActiveFor;
    if (isDue(s)) {
        m_due.push_back(snapshot);
        m_keptBack.clear();
    } else if (s.fresh && m_keptBack.size() < kMostKept) {
        m_keptBack.push_back(snapshot);
    }
    if (!m_due.empty()) {
        m_lastRow = m_due.back()->time;
        m_state = m_due.back()->state;
    }
    return m_due;
}

} // namespace hexapose
