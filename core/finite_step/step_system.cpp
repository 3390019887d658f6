// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/step_system.h"

#include "core/base/input_error.h"
#include "core/finite_step/dense_solve.h"
#include "core/finite_step/rank_check.h"
#include "core/geometry/singular_values.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <utility>

namespace hexapose {

namespace {

/// Nodes whose triangle or tetrahedron is smaller than this part of the product of its sides carry nothing.
constexpr double kFlat = 1e-9;

} // namespace

/// Of carriers, or of their velocities: c is that of the fourth, zero where there is none.
struct StepSystem::Frame {
    Eigen::Vector3d first, a, b, c;
};

StepSystem::Frame StepSystem::frameOf(const Eigen::VectorXd& nodes, const Carriage& carriage) noexcept {
    const auto at = [&](std::size_t k) -> Eigen::Vector3d { return nodes.segment<3>(carriage.nodes[k]); };
    Frame frame{at(0), at(1), at(2), Eigen::Vector3d::Zero()};
    frame.a -= frame.first;
    frame.b -= frame.first;
    if (carriage.hasFour())
        frame.c = at(3) - frame.first;
    return frame;
}

StepSystem::StepSystem(Mechanism mechanism, const std::string& source) : m_mechanism(std::move(mechanism)) {
    const auto& points = m_mechanism.points;
    Eigen::Index count = 0;
    for (const MechanismPoint& point : points) {
        m_first.push_back(point.kind == PointKind::Node ? count : -1);
        count += point.kind == PointKind::Node ? 3 : 0;
    }
    m_homeNodes.resize(count);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (m_first[i] >= 0)
            m_homeNodes.segment<3>(m_first[i]) = points[i].home_B;
    m_carriages.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].kind == PointKind::Carried)
            prepareCarriage(i, source);
    m_homeBody = bodyOf(m_homeNodes);
    m_homeDrive.resize(static_cast<Eigen::Index>(m_mechanism.actuators.size()));
    for (Eigen::Index i = 0; i < m_homeDrive.size(); ++i)
        m_homeDrive[i] = homeValue(m_mechanism, m_mechanism.actuators[static_cast<std::size_t>(i)]);
    m_rows = m_homeDrive.size();
    for (const Constraint& constraint : m_mechanism.constraints)
        m_rows += static_cast<Eigen::Index>(rowCount(constraint));
    if (m_homeNodes.size() == 0 || m_rows == 0)
        throw InputError(source, "has no node, or no equation");

    StepWorkspace memory = workspace();
    assemble(m_homeNodes, m_homeDrive, m_homeDrive, StepSide::Drive, memory);
    if (const std::string fault = rankFault(memory.matrix, rowNames(), unknownNames()); !fault.empty())
        throw InputError(source, fault);
    const Eigen::VectorXd values = singularValues(memory.matrix);
    m_homeCondition = values[0] / values[values.size() - 1];
    m_homeDeterminant = solveInPlace(memory.matrix, memory.right);
}

void StepSystem::prepareCarriage(std::size_t point, const std::string& source) {
    const MechanismPoint& carried = m_mechanism.points[point];
    Carriage& carriage = m_carriages[point];
    for (std::size_t k = 0; k < carried.carriers.size(); ++k)
        carriage.nodes[k] = m_first[carried.carriers[k]];
    const auto [first, a, b, c] = frameOf(m_homeNodes, carriage);
    const Eigen::Vector3d third = carriage.hasFour() ? c : a.cross(b);
    Eigen::Matrix3d axes;
    axes << a, b, third.normalized();
    if (!(std::abs(axes.determinant()) > kFlat * a.norm() * b.norm()))
        throw InputError(source,
                         "point " + carried.name + " is carried by nodes on one line or in one plane");
    const Eigen::Vector3d parts = axes.inverse() * (carried.home_B - first);
    carriage.u = parts[0];
    carriage.v = parts[1];
    carriage.w = parts[2] / third.norm();
}

Eigen::Matrix3Xd StepSystem::bodyOf(const Eigen::VectorXd& nodes) const {
    std::vector<Eigen::Vector3d> points(m_mechanism.points.size());
    placePoints(nodes, points);
    Eigen::Matrix3Xd body(3, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (m_mechanism.points[i].kind == PointKind::Fixed)
            continue;
        body.conservativeResize(3, body.cols() + 1);
        body.rightCols<1>() = points[i];
    }
    return body;
}

std::vector<std::string> StepSystem::rowNames() const {
    std::vector<std::string> names;
    for (const Actuator& actuator : m_mechanism.actuators)
        names.push_back(m_mechanism.nameOf(actuator));
    for (const Constraint& constraint : m_mechanism.constraints)
        names.insert(names.end(), rowCount(constraint), m_mechanism.nameOf(constraint));
    return names;
}

std::vector<std::string> StepSystem::unknownNames() const {
    std::vector<std::string> names;
    for (const MechanismPoint& point : m_mechanism.points)
        if (point.kind == PointKind::Node)
            for (const char* axis : {"x of ", "y of ", "z of "})
                names.push_back(axis + point.name);
    return names;
}

StepWorkspace StepSystem::workspace() const {
    StepWorkspace memory;
    memory.matrix.setZero(m_rows, m_homeNodes.size());
    memory.right.setZero(m_rows);
    memory.points.resize(m_mechanism.points.size());
    memory.velocities.resize(m_mechanism.points.size());
    return memory;
}

void StepSystem::placePoints(const Eigen::VectorXd& nodes,
                             std::vector<Eigen::Vector3d>& points) const noexcept {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Carriage& c = m_carriages[i];
        switch (m_mechanism.points[i].kind) {
        case PointKind::Fixed:
            points[i] = m_mechanism.points[i].home_B;
            break;
        case PointKind::Node:
            points[i] = nodes.segment<3>(m_first[i]);
            break;
        case PointKind::Carried: {
            const Frame f = frameOf(nodes, c);
            points[i] = f.first + c.u * f.a + c.v * f.b + c.w * (c.hasFour() ? f.c : f.a.cross(f.b));
            break;
        }
        }
    }
}

void StepSystem::movePoints(const Eigen::VectorXd& nodes, const Eigen::VectorXd& velocity,
                            std::vector<Eigen::Vector3d>& velocities) const noexcept {
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        velocities[i].setZero();
        if (m_first[i] >= 0)
            velocities[i] = velocity.segment<3>(m_first[i]);
        if (m_mechanism.points[i].kind != PointKind::Carried)
            continue;
        const Carriage& c = m_carriages[i];
        const Frame f = frameOf(nodes, c), rate = frameOf(velocity, c);
        velocities[i] = rate.first + c.u * rate.a + c.v * rate.b;
        if (c.hasFour())
            velocities[i] += c.w * rate.c;
        else
            velocities[i] += c.w * (rate.a.cross(f.b) + f.a.cross(rate.b));
    }
}

/// Acceleration of a carried point that comes from the velocities of its nodes alone.
Eigen::Vector3d StepSystem::bend(std::size_t point, const Eigen::VectorXd& velocity) const noexcept {
    const Carriage& c = m_carriages[point];
    if (m_mechanism.points[point].kind != PointKind::Carried || c.hasFour())
        return Eigen::Vector3d::Zero();
    const Frame rate = frameOf(velocity, c);
    return 2.0 * c.w * rate.a.cross(rate.b);
}

/// Writes the row, divided by its natural length (the norm over the moving points it names), which it
/// returns.
double StepSystem::addRow(Eigen::Index index, const StepRow& row, const Eigen::VectorXd& nodes,
                          Eigen::MatrixXd& matrix) const noexcept {
    double square = 0.0;
    for (std::size_t i = 0; i < row.count; ++i)
        if (m_mechanism.points[row.terms[i].point].kind != PointKind::Fixed)
            square += row.terms[i].gradient.squaredNorm();
    const double length = square == 0.0 ? 1.0 : std::sqrt(square); // a row of zeros shows in the rank
    matrix.row(index).setZero();
    const auto put = [&](Eigen::Index first, const Eigen::Vector3d& gradient) {
        matrix.row(index).segment<3>(first) += gradient.transpose();
    };
    for (std::size_t i = 0; i < row.count; ++i) {
        const std::size_t point = row.terms[i].point;
        const Eigen::Vector3d g = row.terms[i].gradient / length;
        if (m_first[point] >= 0)
            put(m_first[point], g);
        if (m_mechanism.points[point].kind != PointKind::Carried)
            continue;
        const Carriage& c = m_carriages[point];
        if (c.hasFour()) {
            put(c.nodes[0], (1.0 - c.u - c.v - c.w) * g);
            put(c.nodes[1], c.u * g);
            put(c.nodes[2], c.v * g);
            put(c.nodes[3], c.w * g);
            continue;
        }
        const Frame f = frameOf(nodes, c);
        const Eigen::Vector3d alongA = c.u * g + c.w * f.b.cross(g);
        const Eigen::Vector3d alongB = c.v * g + c.w * g.cross(f.a);
        put(c.nodes[0], g - alongA - alongB);
        put(c.nodes[1], alongA);
        put(c.nodes[2], alongB);
    }
    return length;
}

void StepSystem::assemble(const Eigen::VectorXd& nodes, const Eigen::VectorXd& from,
                          const Eigen::VectorXd& to, StepSide side, StepWorkspace& memory) const noexcept {
    placePoints(nodes, memory.points);
    Eigen::Index index = 0;
    const auto write = [&](const StepRow& row) {
        const double length = addRow(index, row, nodes, memory.matrix);
        const double right = side == StepSide::Drive    ? row.drive
                             : side == StepSide::Closed ? row.drive - row.misfit
                                                        : -row.misfit;
        memory.right[index++] = right / length;
    };
    for (std::size_t i = 0; i < m_mechanism.actuators.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const double start = side == StepSide::Correction ? to[k] : from[k];
        write(stepRow(m_mechanism, m_mechanism.actuators[i], memory.points, start, to[k]));
    }
    for (const Constraint& constraint : m_mechanism.constraints)
        for (std::size_t i = 0; i < rowCount(constraint); ++i)
            write(stepRow(m_mechanism, constraint, memory.points, i));
}

double StepSystem::step(const Eigen::VectorXd& nodes, const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                        StepSide side, StepWorkspace& memory, Eigen::VectorXd& shift) const noexcept {
    assemble(nodes, from, to, side, memory);
    const double determinant = solveInPlace(memory.matrix, memory.right);
    shift = memory.right;
    return determinant / m_homeDeterminant;
}

double StepSystem::motion(const Eigen::VectorXd& nodes, std::span<const DriveState> drive,
                          StepWorkspace& memory, Eigen::VectorXd& velocity,
                          Eigen::VectorXd& acceleration) const noexcept {
    placePoints(nodes, memory.points);
    double determinant = 0.0;
    for (const bool second : {false, true}) {
        if (second)
            movePoints(nodes, velocity, memory.velocities);
        Eigen::Index index = 0;
        const auto write = [&](const StepRow& row, double right) {
            for (std::size_t i = 0; i < row.count && second; ++i)
                right -= row.terms[i].gradient.dot(bend(row.terms[i].point, velocity));
            const double length = addRow(index, row, nodes, memory.matrix);
            memory.right[index++] = right / length;
        };
        for (std::size_t i = 0; i < m_mechanism.actuators.size(); ++i) {
            const Actuator& actuator = m_mechanism.actuators[i];
            write(stepRow(m_mechanism, actuator, memory.points, drive[i].value, drive[i].value),
                  second ? accelerationOf(actuator, memory.points, memory.velocities, drive[i])
                         : rateOf(actuator, memory.points, drive[i]));
        }
        for (const Constraint& constraint : m_mechanism.constraints)
            for (std::size_t i = 0; i < rowCount(constraint); ++i)
                write(stepRow(m_mechanism, constraint, memory.points, i),
                      second ? accelerationOf(constraint, memory.velocities) : 0.0);
        determinant = solveInPlace(memory.matrix, memory.right);
        (second ? acceleration : velocity) = memory.right;
    }
    return determinant / m_homeDeterminant;
}

double StepSystem::determinantRatio(const Eigen::VectorXd& nodes, const Eigen::VectorXd& drive,
                                    StepWorkspace& memory) const noexcept {
    assemble(nodes, drive, drive, StepSide::Drive, memory);
    return solveInPlace(memory.matrix, memory.right) / m_homeDeterminant;
}

double StepSystem::smallestSingularValue(const Eigen::VectorXd& nodes, const Eigen::VectorXd& drive) const {
    StepWorkspace memory = workspace();
    assemble(nodes, drive, drive, StepSide::Drive, memory);
    if (!memory.matrix.allFinite())
        return 0.0;
    return singularValues(memory.matrix).minCoeff();
}

double StepSystem::residual(const Eigen::VectorXd& nodes, const Eigen::VectorXd& drive,
                            StepWorkspace& memory) const noexcept {
    assemble(nodes, drive, drive, StepSide::Correction, memory);
    return memory.right.norm();
}

} // namespace hexapose
