// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/run_log.h"

#include <algorithm>
#include <cmath>

namespace hexapose::apptest {

namespace {

constexpr double kSameNumberMm = 1e-9;
constexpr double kSolvedMm = 1e-4; ///< between measured lengths and those of the logged pose

bool isSame(const Six& a, const std::vector<double>& b, double tolerance) {
    return b.size() == 6 && std::equal(a.begin(), a.end(), b.begin(), [tolerance](double x, double y) {
               return std::abs(x - y) <= tolerance;
           });
}

} // namespace

std::string RunLog::strayMeasurement(const std::vector<LenFrame>& sent) const {
    std::size_t next = 0; // rows and frames come in the same order
    std::size_t found = 0;
    for (std::size_t row = 0; row + 1 < m_table.rows.size(); ++row) {
        const std::vector<double> lengths = m_table.six(row, lengthColumns());
        if (lengths.empty())
            continue;
        while (next < sent.size() && !isSame(sent[next].lengths, lengths, kSameNumberMm))
            ++next;
        if (next++ == sent.size())
            return "row " + std::to_string(row + 2) + " holds lengths that no good frame brought";
        ++found;
    }
    return found > 0 ? "" : "no measurement in the log";
}

std::string RunLog::strayPose(const Machine& machine) const {
    std::size_t found = 0;
    for (std::size_t row = 0; row + 1 < m_table.rows.size(); ++row) {
        const std::vector<double> pose = m_table.six(row, poseColumns());
        if (pose.empty())
            continue;
        if (pose.size() != 6)
            return "row " + std::to_string(row + 2) + " holds half a pose";
        Six values{};
        std::copy(pose.begin(), pose.end(), values.begin());
        if (!isSame(machine.lengths(values), m_table.six(row, lengthColumns()), kSolvedMm))
            return "row " + std::to_string(row + 2) + " holds a pose of other lengths";
        ++found;
    }
    return found > 0 ? "" : "no pose in the log";
}

std::size_t RunLog::sentAfterLast(const std::vector<LenFrame>& sent) const {
    for (std::size_t row = m_table.rows.size(); row-- > 0;) {
        if (m_table.rows[row].size() < m_table.header.size())
            continue; // the half-written one
        const std::vector<double> lengths = m_table.six(row, lengthColumns());
        if (lengths.empty())
            continue;
        const auto last = std::find_if(sent.rbegin(), sent.rend(), [&](const LenFrame& frame) {
            return isSame(frame.lengths, lengths, kSameNumberMm);
        });
        return static_cast<std::size_t>(last - sent.rbegin());
    }
    return sent.size();
}

long RunLog::dropped() const {
    return m_table.rows.empty() ? -1 : std::lround(m_table.number(m_table.rows.size() - 1, "dropped"));
}

} // namespace hexapose::apptest
