// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/foreign_controller.h"

#include "tests/app/process.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hexapose::apptest {

namespace {

double largestGap(const Six& a, const Six& b) {
    double gap = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        gap = std::max(gap, std::abs(a[i] - b[i]));
    return gap;
}

} // namespace

ForeignController::ForeignController(const std::string& link, const Traits& traits, const Plan& plan)
    : m_traits(traits), m_plan(plan), m_link(link), m_wake(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    plugIn();
    boot();
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

ForeignController::~ForeignController() {
    m_thread.request_stop();
    ::eventfd_write(m_wake, 1);
    m_thread.join();
    unplug();
    ::close(m_wake);
    ::unlink(m_link.c_str());
}

void ForeignController::boot() {
    ++m_boots;
    m_bootTime = m_now;
    m_state = m_traits.bootState;
    m_legs = m_traits.homeMm;
    if (m_state == 'U')
        for (double& leg : m_legs)
            leg += m_traits.awayMm;
    m_goals = m_legs;
    m_period = m_traits.period;
    m_nextReport = m_now + m_period;
    m_answers.clear();
    m_homedAt.reset();
    m_firstSet.reset();
    m_hellos = 0;
    m_identified = false;
    m_reporting = m_traits.reportsUnasked || m_traits.listenOnly;
    m_number = 0;
    m_setNumber = -1;
    m_lastHostNumber.reset();
    m_lastReport = {};
}

ForeignController::Clock::time_point ForeignController::nextDue() const {
    Clock::time_point due = m_now + std::chrono::milliseconds(5); // the legs' step
    if (m_reporting)
        due = std::min(due, m_nextReport);
    if (!m_answers.empty())
        due = std::min(due, m_answers.front().first);
    return due;
}

void ForeignController::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        Clock::time_point due;
        std::array<pollfd, 2> waits{};
        {
            const Lock lock(m_mutex);
            due = nextDue();
            waits = {{{m_master, POLLIN, 0}, {m_wake, POLLIN, 0}}};
        }
        const auto left = std::max(due - Clock::now(), Clock::duration::zero());
        const timespec timeout{0, std::chrono::nanoseconds(left).count()};
        ::ppoll(waits.data(), waits.size(), &timeout, nullptr);
        const Lock lock(m_mutex);
        if (waits[0].revents != 0)
            readPort();
        advance(Clock::now());
        flush();
        m_changed.notify_all();
    }
}

void ForeignController::advance(Clock::time_point now) {
    moveLegs(std::chrono::duration<double>(now - m_now).count());
    m_longestStep = std::max(m_longestStep, now - m_now);
    m_now = now;
    if (m_plugAt && now >= *m_plugAt) {
        m_plugAt.reset();
        plugIn();
        boot();
    }
    if (m_homedAt && now >= *m_homedAt) {
        m_homedAt.reset();
        m_state = 'D';
    }
    if (m_state == 'E' && now - m_lastHeard > m_traits.watchdog) {
        m_state = 'S';
        m_goals = m_legs;
        ++m_watchdogTrips;
    }
    misbehave();
    while (!m_answers.empty() && m_answers.front().first <= now) {
        send(m_answers.front().second);
        m_answers.pop_front();
    }
    for (; m_nextReport <= now; m_nextReport += m_period)
        if (m_reporting && m_nextReport + m_period > now)
            report();
}

void ForeignController::moveLegs(double seconds) {
    if (m_state != 'E' && !m_homedAt)
        return;
    const double step = m_traits.speedMmPerS * seconds;
    for (std::size_t i = 0; i < m_legs.size(); ++i)
        m_legs[i] += std::clamp(m_goals[i] - m_legs[i], -step, step);
}

void ForeignController::misbehave() {
    if (m_misdeedDone || m_plan.misdeed == Misdeed::None || m_state != 'E' || !m_firstSet ||
        largestGap(*m_firstSet, m_legs) < m_plan.afterMm)
        return;
    m_misdeedDone = true;
    switch (m_plan.misdeed) {
    case Misdeed::None:
        break;
    case Misdeed::Silence:
        m_silentUntil = m_now + m_plan.length;
        break;
    case Misdeed::RefuseSets:
        m_refusing = true;
        break;
    case Misdeed::Fault:
        m_state = 'F';
        send(foreignFrame("FAULT,42,drive 3: over-current, see manual"));
        break;
    case Misdeed::Stop:
        m_state = 'S';
        break;
    case Misdeed::Restart:
        boot();
        break;
    case Misdeed::Unplug:
        unplug();
        m_plugAt = m_now + m_plan.length;
        break;
    }
}

void ForeignController::report() {
    LenFrame frame{m_number++,
                   std::chrono::microseconds(
                       std::chrono::duration_cast<std::chrono::microseconds>(m_nextReport - m_bootTime))
                       .count(),
                   m_legs, m_state, m_setNumber};
    const double unit = std::pow(10.0, m_traits.decimals);
    for (double& length : frame.lengths)
        length = std::round(length * unit) / unit;
    if (m_now < m_silentUntil)
        return;
    const std::string lineEnd = m_traits.carriageReturn ? "\r\n" : "\n";
    if (m_traits.listenOnly) {
        const std::vector<std::string> fields = splitFields(frame.payload(m_traits.decimals));
        std::string line = fields[3];
        for (std::size_t i = 4; i < 9; ++i)
            line += ";" + fields[i];
        return send(line + lineEnd);
    }
    if (m_plan.badEvery > 0 && m_number > 2 && m_number % m_plan.badEvery == 0 && m_unsent.empty())
        send(badFrame(static_cast<std::size_t>(m_badSent++), m_lastReport, frame, m_traits.decimals));
    m_lastReport = frame;
    m_enabledReported = m_enabledReported || m_state == 'E';
    m_reports.push_back(frame);
    send(foreignFrame(frame.payload(m_traits.decimals), lineEnd));
}

void ForeignController::answer(const std::string& payload) {
    m_answers.emplace_back(m_now + m_traits.answerDelay,
                           foreignFrame(payload, m_traits.carriageReturn ? "\r\n" : "\n"));
}

void ForeignController::reply(const std::string& type, bool allowed) {
    answer(allowed ? "OK," + type : "ERR," + type + ",STATE,not in state " + m_state);
}

bool ForeignController::waitFor(const std::function<bool()>& condition) {
    Lock lock(m_mutex);
    return m_changed.wait_for(lock, kPatience, condition);
}

std::vector<std::string> ForeignController::payloads(const std::string& type) const {
    const Lock lock(m_mutex);
    std::vector<std::string> result;
    for (const Received& frame : m_received)
        if (type.empty() || splitFields(frame.payload).front() == type)
            result.push_back(frame.payload);
    return result;
}

std::vector<std::string> ForeignController::violations() const {
    const Lock lock(m_mutex);
    return m_violations;
}

std::vector<LenFrame> ForeignController::reports() const {
    const Lock lock(m_mutex);
    return m_reports;
}

int ForeignController::badSent() const {
    const Lock lock(m_mutex);
    return m_badSent;
}

int ForeignController::watchdogTrips() const {
    const Lock lock(m_mutex);
    return m_watchdogTrips;
}

bool ForeignController::misdeedDone() const {
    const Lock lock(m_mutex);
    return m_misdeedDone;
}

char ForeignController::state() const {
    const Lock lock(m_mutex);
    return m_state;
}

int ForeignController::boots() const {
    const Lock lock(m_mutex);
    return m_boots;
}

ForeignController::Ms ForeignController::typicalGap() const {
    const Lock lock(m_mutex);
    std::vector<Ms> gaps = m_gaps;
    if (gaps.empty())
        return Ms::max();
    const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
    std::nth_element(gaps.begin(), middle, gaps.end());
    return *middle;
}

bool ForeignController::starved() const {
    constexpr Ms kOwed{100};
    const Lock lock(m_mutex);
    return m_longestStep > kOwed;
}

Six ForeignController::legs() const {
    const Lock lock(m_mutex);
    return m_legs;
}

} // namespace hexapose::apptest
