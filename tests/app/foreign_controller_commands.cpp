// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/foreign_controller.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace hexapose::apptest {

namespace {

/// A host learns of a stop that was not its own from the next report, and its set-points may cross that.
constexpr int kSetsThatCross = 20;
/// Between two set-points, and between the legs and the first: far below a move, far above a late cycle.
constexpr double kJumpMm = 25.0;

const std::set<std::string> kBare{"HOME", "ENABLE", "DISABLE", "STOP", "CLEAR"};

} // namespace

void ForeignController::take(const ForeignReader::Item& item) {
    if (!item.payload)
        return violate("not a frame: " + item.bytes);
    m_received.push_back({m_now, *item.payload});
    if (m_traits.listenOnly) {
        if (*item.payload != "HELLO,1")
            violate("a command to a sender that takes none: " + *item.payload);
        return;
    }
    const Clock::time_point now = Clock::now();
    if (m_state == 'E')
        m_gaps.push_back(std::chrono::duration_cast<Ms>(now - m_lastHeard));
    m_lastHeard = now;
    takeCommand(splitFields(*item.payload));
}

void ForeignController::takeCommand(const std::vector<std::string>& fields) {
    const std::string& type = fields.front();
    if (type == "SET")
        return takeSet(fields);
    if (type == "HELLO") {
        if (fields != std::vector<std::string>{"HELLO", "1"})
            violate("HELLO of another form");
        if (++m_hellos < m_traits.hellosNeeded)
            return;
        if (!m_traits.helloAnswer.empty())
            return answer(m_traits.helloAnswer);
        m_identified = m_reporting = true;
        return answer("IDENT,1," + m_traits.name + ",6," + std::to_string(m_traits.period.count()) + "," +
                      shortest(m_traits.minMm) + "," + shortest(m_traits.maxMm));
    }
    if (!m_identified && m_boots == 1)
        violate(type + " before IDENT");
    if (type == "PERIOD") {
        const int ms = fields.size() == 2 && isWireNumber(fields[1]) ? std::atoi(fields[1].c_str()) : 0;
        if (ms < 1 || ms > 1000)
            violate("PERIOD of another form or range");
        if (!m_traits.obeysPeriod)
            return answer("ERR,PERIOD,RANGE,my period is fixed, sorry");
        m_period = Ms(ms);
        return reply(type, true);
    }
    if (!kBare.contains(type) || fields.size() != 1)
        return violate("no such command: " + type);
    reply(type, obey(type));
}

bool ForeignController::obey(const std::string& type) {
    const char before = m_state;
    if (type == "STOP" || type == "DISABLE")
        m_endedByHost = true;
    if (type == "STOP") {
        m_goals = m_legs;
        m_state = before == 'F' ? 'F' : 'S';
        return true;
    }
    if (type == "CLEAR") {
        m_state = before == 'S' || before == 'F' ? 'D' : before;
        return true;
    }
    if (type == "HOME") {
        if (before != 'U' && before != 'D')
            return false;
        m_goals = m_traits.homeMm;
        m_homedAt = m_now + m_traits.homing;
        return true;
    }
    if (type == "ENABLE") {
        m_endedByHost = m_enabledReported = false;
        m_setsWhileDown = 0;
        m_firstSet.reset();
    }
    if (before != 'D' && before != 'E') {
        if (type == "ENABLE")
            violate("ENABLE in state " + std::string(1, before));
        return false;
    }
    m_goals = m_legs;
    m_state = type == "ENABLE" ? 'E' : 'D';
    return true;
}

void ForeignController::takeSet(const std::vector<std::string>& fields) {
    const bool form = fields.size() == 8 && std::all_of(fields.begin() + 1, fields.end(), isWireNumber) &&
                      fields[1].find_first_of("-.") == std::string::npos;
    if (!form) {
        violate("SET of another form");
        return answer("ERR,SET,FORMAT,eh?");
    }
    Six lengths{};
    for (std::size_t i = 0; i < lengths.size(); ++i)
        lengths[i] = std::strtod(fields[i + 2].c_str(), nullptr);
    const long number = std::atol(fields[1].c_str());
    checkSet(lengths, number);
    if (m_state != 'E')
        return answer("ERR,SET,STATE,drives are off");
    const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
    if (m_refusing || *least < m_traits.minMm || *most > m_traits.maxMm)
        return answer("ERR,SET,RANGE,leg 2, out of my range");
    if (!m_firstSet)
        m_firstSet = m_legs;
    m_goals = m_lastSet = lengths;
    m_setNumber = static_cast<int>(number);
}

void ForeignController::checkSet(const Six& lengths, long number) {
    if (number < 0 || number > 65535 || (m_lastHostNumber && number != (*m_lastHostNumber + 1) % 65536))
        violate("SET numbers do not count up: " + std::to_string(number));
    m_lastHostNumber = number;
    if (!m_identified && m_boots == 1)
        violate("SET before IDENT");
    if (m_endedByHost)
        violate("SET after STOP or DISABLE without ENABLE, or before any ENABLE");
    if (!m_enabledReported && m_boots == 1)
        violate("SET before state E was reported");
    if (m_state != 'E' && ++m_setsWhileDown > kSetsThatCross)
        violate("SET again and again while not enabled");
    if (m_state != 'E' || m_refusing)
        return;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        if (lengths[i] < m_traits.minMm || lengths[i] > m_traits.maxMm)
            violate("SET beyond the limits of IDENT: " + std::to_string(lengths[i]));
        const double from = m_firstSet ? m_lastSet[i] : m_legs[i];
        if (std::abs(lengths[i] - from) > kJumpMm)
            violate("SET jumps by " + std::to_string(lengths[i] - from) + " mm");
    }
}

} // namespace hexapose::apptest
