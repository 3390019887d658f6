// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/motion_tracking.h"

#include "core/base/input_error.h"
#include "core/finite_step/node_path.h"
#include "core/finite_step/pose_errors.h"

#include <limits>
#include <utility>

namespace hexapose {

namespace {

/// Steps of the path from home to where a drive begins.
constexpr int kLeadInSteps = 1000;

Eigen::VectorXd valuesOf(const std::vector<DriveState>& states) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(states.size()));
    for (std::size_t i = 0; i < states.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = states[i].value;
    return values;
}

Eigen::VectorXd firstNodes(const StepSystem& system, const DrivePath& drive) {
    std::vector<DriveState> first(system.mechanism().actuators.size());
    drive.at(drive.begin(), first);
    const Eigen::VectorXd values = valuesOf(first);
    if (values == system.homeDrive())
        return system.homeNodes();
    const StraightDrive leadIn(system.homeDrive(), values);
    NodePath path(system, leadIn, kLeadInSteps, StepForm::Corrected, system.homeNodes());
    while (path.advance()) {
    }
    Eigen::VectorXd nodes = path.nodes(), shift = nodes;
    StepWorkspace memory = system.workspace();
    if (path.isSingular() || !solveNodes(system, values, memory, shift, nodes))
        throw InputError("drive", "where it begins cannot be reached from home along a straight path of the "
                                  "actuators: it meets a singular pose");
    return nodes;
}

/// Pose and rates of the output where nodes are: the rates by the derivatives of the equations, at the nodes
/// of the rigid body that was fitted, for what has grown out of shape has no velocity.
class MotionReader {
public:
    explicit MotionReader(const StepSystem& system)
        : m_system(system), m_memory(system.workspace()), m_velocity(system.homeNodes()),
          m_acceleration(system.homeNodes()) {}

    BodyMotion read(const Eigen::VectorXd& nodes, const std::vector<DriveState>& drive) {
        const BodyFit& output = m_system.mechanism().output;
        BodyMotion body = poseOfNodes(m_system, nodes);
        const Eigen::Matrix3Xd rigid =
            (body.R_BP * (asPoints(m_system.homeNodes()).colwise() - output.p_OP_home_B)).colwise() +
            body.p_OP_B;
        m_system.motion(rigid.reshaped(), drive, m_memory, m_velocity, m_acceleration);
        addVelocity(output, body, rigid, asPoints(m_velocity));
        addAcceleration(output, body, rigid, asPoints(m_acceleration));
        return body;
    }
    BodyMotion readExact(Eigen::VectorXd& nodes, const std::vector<DriveState>& drive) {
        if (solveNodes(m_system, valuesOf(drive), m_memory, m_velocity, nodes))
            return read(nodes, drive);
        BodyMotion none;
        none.p_OP_B.setConstant(std::numeric_limits<double>::quiet_NaN());
        none.R_BP.setConstant(std::numeric_limits<double>::quiet_NaN());
        none.velocity = none.acceleration = none.angularVelocity = none.angularAcceleration = none.p_OP_B;
        return none;
    }

private:
    const StepSystem& m_system;
    StepWorkspace m_memory;
    Eigen::VectorXd m_velocity, m_acceleration;
};

/// Rates from differences of the steps; the first row keeps its exact ones, which the paper takes as given.
void setAverages(std::vector<TrackRow>& rows) {
    if (!rows.empty()) {
        const BodyMotion& given = rows.front().exact;
        BodyMotion& first = rows.front().computed;
        first.velocity = given.velocity;
        first.acceleration = given.acceleration;
        first.angularVelocity = given.angularVelocity;
        first.angularAcceleration = given.angularAcceleration;
    }
    for (std::size_t k = 1; k < rows.size(); ++k) {
        const BodyMotion& before = rows[k - 1].computed;
        BodyMotion& now = rows[k].computed;
        const double step = rows[k].time - rows[k - 1].time;
        now.velocity = (now.p_OP_B - before.p_OP_B) / step;
        now.angularVelocity = rotationVector(before.R_BP, now.R_BP) / step;
        now.acceleration = (now.velocity - before.velocity) / step;
        now.angularAcceleration = (now.angularVelocity - before.angularVelocity) / step;
    }
    if (rows.size() > 1) {
        const BodyMotion& from = rows[rows.size() > 2 ? 2 : 0].computed;
        rows[1].computed.acceleration = from.acceleration;
        rows[1].computed.angularAcceleration = from.angularAcceleration;
    }
}

} // namespace

Track trackMotion(const StepSystem& system, const DrivePath& drive, const TrackOptions& options) {
    Eigen::VectorXd exactNodes = firstNodes(system, drive);
    NodePath path(system, drive, options.steps, options.form, exactNodes);
    MotionReader reader(system);
    Track track;
    track.rows.reserve(static_cast<std::size_t>(options.steps) + 1);
    const auto record = [&] {
        TrackRow row;
        row.time = path.time();
        row.q = path.q();
        row.drive = path.drive();
        row.computed = reader.read(path.nodes(), path.drive());
        row.exact = reader.readExact(exactNodes, path.drive());
        track.rows.push_back(std::move(row));
    };
    record();
    while (path.advance())
        record();
    track.isSingular = path.isSingular();
    if (track.isSingular && path.step() == static_cast<int>(track.rows.size()))
        record(); // where the rule said stop
    if (options.rates == TrackRates::Averages)
        setAverages(track.rows);
    track.smallestSingularValue = path.smallestSingularValue();
    return track;
}

} // namespace hexapose
