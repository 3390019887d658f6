// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/view_history.h"

namespace hexapose {

namespace {

constexpr std::chrono::milliseconds kBurst{700};
constexpr std::size_t kMostViews = 200;

} // namespace

void ViewHistory::show(const PageView& view, Step step, Time now) {
    if (view == m_views[m_at])
        return;
    const bool goesOn = step == Step::Burst && m_lastBurst && now - *m_lastBurst < kBurst;
    m_lastBurst = step == Step::Burst ? std::optional(now) : std::nullopt;
    m_views.resize(m_at + 1);
    if (goesOn) {
        m_views.back() = view;
        return;
    }
    m_views.push_back(view);
    if (m_views.size() > kMostViews)
        m_views.erase(m_views.begin());
    m_at = m_views.size() - 1;
}

void ViewHistory::goBack() {
    m_lastBurst.reset();
    if (canGoBack())
        --m_at;
}

void ViewHistory::goForward() {
    m_lastBurst.reset();
    if (canGoForward())
        ++m_at;
}

} // namespace hexapose
