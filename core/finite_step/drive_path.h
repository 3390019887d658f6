// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/mechanism.h"
#include "core/finite_step/step_equations.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace hexapose {

/// What the actuators do over time. Values in m or rad, time in s.
class DrivePath {
public:
    virtual ~DrivePath() = default;
    virtual double begin() const noexcept = 0;
    virtual double end() const noexcept = 0;
    /// One state an actuator, in their order. Allocates nothing.
    virtual void at(double time, std::span<DriveState> states) const noexcept = 0;
};

/// All actuators straight from one set of values to another within a unit of time: the path of the paper
/// where none is given.
class StraightDrive final : public DrivePath {
public:
    StraightDrive(Eigen::VectorXd from, Eigen::VectorXd to);
    double begin() const noexcept override { return 0.0; }
    double end() const noexcept override { return 1.0; }
    void at(double time, std::span<DriveState> states) const noexcept override;

private:
    Eigen::VectorXd m_from, m_to;
};

/// home + amplitude sin(rate t), as the mechanism describes it.
class ReferenceDrive final : public DrivePath {
public:
    /// duration: s.
    ReferenceDrive(const Mechanism& mechanism, double duration);
    double begin() const noexcept override { return 0.0; }
    double end() const noexcept override { return m_duration; }
    void at(double time, std::span<DriveState> states) const noexcept override;

private:
    struct Wave {
        double middle, amplitude, rate;
    };
    std::vector<Wave> m_waves;
    double m_duration;
};

/// Through samples: polynomials of degree 5 that meet value, rate and second derivative at each. Where these
/// are not given they are those of the polynomial through the seven nearest samples.
class TableDrive final : public DrivePath {
public:
    struct Samples {
        std::vector<double> times;                   ///< rising; two or more
        std::vector<std::vector<DriveState>> states; ///< [actuator][sample]
        bool withRates = false;                      ///< rates and accelerations are given
    };
    /// Not checked: that times rise, and that each actuator has a state for every time.
    explicit TableDrive(Samples samples);
    double begin() const noexcept override { return m_samples.times.front(); }
    double end() const noexcept override { return m_samples.times.back(); }
    void at(double time, std::span<DriveState> states) const noexcept override;

private:
    Samples m_samples;
};

} // namespace hexapose
