// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/bad_frames.h"
#include "tests/app/machine.h"
#include "tests/app/scratch.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hexapose::apptest {

/// The log of a run, held against what the controller sent and against inverse kinematics.
class RunLog {
public:
    explicit RunLog(const std::string& file) : m_text(readText(file)), m_table(m_text) {}

    /// "" when every measurement in the log is one that was sent in a good frame, and there are some.
    std::string strayMeasurement(const std::vector<LenFrame>& sent) const;
    /// "" when every pose in the log belongs to the lengths of its row, and there are some.
    std::string strayPose(const Machine& machine) const;
    bool has(const std::string& words) const { return m_text.find(words) != std::string::npos; }
    /// How many of the sent frames came after the last measurement in the log.
    std::size_t sentAfterLast(const std::vector<LenFrame>& sent) const;
    long dropped() const; ///< in the last row
    const Table& table() const { return m_table; }

private:
    std::string m_text;
    Table m_table;
};

} // namespace hexapose::apptest
