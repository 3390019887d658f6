// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/node_path.h"

#include <limits>

namespace hexapose {

namespace {

constexpr int kMostCorrections = 30;
/// A correction below this part of the nodes' extent is rounding.
constexpr double kAtRest = 1e-14;

} // namespace

NodePath::NodePath(const StepSystem& system, const DrivePath& drive, int steps, StepForm form,
                   const Eigen::VectorXd& nodes)
    : m_system(system), m_path(drive), m_steps(steps), m_form(form), m_memory(system.workspace()),
      m_drive(system.mechanism().actuators.size()), m_nodes(nodes), m_before(nodes), m_shift(nodes),
      m_from(system.homeDrive()), m_to(system.homeDrive()), m_fromBefore(system.homeDrive()), m_q(1.0),
      m_rule(steps, 1.0) {
    readDrive(0, m_from);
    m_fromBefore = m_from;
    m_q = system.determinantRatio(m_nodes, m_from, m_memory);
    m_rule = StopRule(steps, m_q);
    m_singular = m_rule.stops(m_q);
}

double NodePath::timeOf(int step) const noexcept {
    if (step == m_steps)
        return m_path.end();
    return m_path.begin() + (m_path.end() - m_path.begin()) * step / m_steps;
}

void NodePath::readDrive(int step, Eigen::VectorXd& values) noexcept {
    m_path.at(timeOf(step), m_drive);
    for (std::size_t i = 0; i < m_drive.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = m_drive[i].value;
}

bool NodePath::advance() noexcept {
    if (m_singular || m_step == m_steps)
        return false;
    readDrive(m_step + 1, m_to);
    m_system.step(m_nodes, m_from, m_to, m_form == StepForm::Open ? StepSide::Drive : StepSide::Closed,
                  m_memory, m_shift);
    m_before = m_nodes;
    m_fromBefore = m_from;
    m_nodes += m_shift;
    m_from = m_to;
    if (m_form == StepForm::Corrected) {
        m_system.step(m_nodes, m_from, m_to, StepSide::Correction, m_memory, m_shift);
        m_nodes += m_shift;
    }
    ++m_step;
    const double q = m_system.determinantRatio(m_nodes, m_from, m_memory);
    m_singular = m_rule.stops(q);
    if (!m_singular || q > 0.0) {
        m_q = q;
        return !m_singular;
    }
    m_nodes = m_before; // already past it
    m_from = m_fromBefore;
    readDrive(--m_step, m_to);
    return false;
}

bool solveNodes(const StepSystem& system, const Eigen::VectorXd& drive, StepWorkspace& memory,
                Eigen::VectorXd& shift, Eigen::VectorXd& nodes) noexcept {
    double least = std::numeric_limits<double>::infinity();
    const double extent = nodes.cwiseAbs().maxCoeff();
    for (int i = 0; i < kMostCorrections; ++i) {
        system.step(nodes, drive, drive, StepSide::Correction, memory, shift);
        const double size = shift.cwiseAbs().maxCoeff();
        if (!(size < 2.0 * least))
            return size <= 1e3 * kAtRest * extent;
        nodes += shift;
        if (size <= kAtRest * extent)
            return true;
        least = size;
    }
    return false;
}

} // namespace hexapose
