// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/report/settled_sample.h"

#include <utility>

namespace hexapose {

namespace {

/// A goal that went through a file in mm and degrees is the same goal still. m and rad.
constexpr double kSameGoal = 1e-9;

bool isSameGoal(const Pose& a, const Pose& b) {
    return (a.toVector() - b.toVector()).cwiseAbs().maxCoeff() <= kSameGoal;
}

} // namespace

std::optional<SettledSample> SettledSampler::add(const Snapshot& snapshot) {
    const bool standing = snapshot.state == RunState::Enabled && snapshot.goalPose &&
                          (!m_open || isSameGoal(m_open->target, *snapshot.goalPose));
    if (!standing) {
        std::optional<SettledSample> left = finish();
        m_moved = isInMotion(snapshot.state);
        return left;
    }
    if (!m_moved || !snapshot.fresh || !snapshot.measuredLengths)
        return std::nullopt;
    // After a gap in the data the window may be over already.
    if (m_open && snapshot.time - m_open->start > m_window)
        return close();
    if (!m_open) {
        m_open.emplace();
        m_open->target = *snapshot.goalPose;
        m_open->start = snapshot.time;
        m_sum.setZero();
    }
    m_sum += *snapshot.measuredLengths;
    ++m_open->measurements;
    m_last = snapshot.time;
    if (m_last - m_open->start >= m_window)
        return close();
    return std::nullopt;
}

std::optional<SettledSample> SettledSampler::finish() {
    if (!m_open || m_last - m_open->start < m_window / 2) {
        m_open.reset();
        return std::nullopt;
    }
    return close();
}

SettledSample SettledSampler::close() {
    SettledSample sample = *std::exchange(m_open, std::nullopt);
    sample.meanLengths = m_sum / sample.measurements;
    m_moved = false;
    return sample;
}

} // namespace hexapose
