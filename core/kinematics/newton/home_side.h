// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/leg_equations.h"

#include <optional>

namespace hexapose {

/// Which side of the singular surface a pose is on, and whether a path there stays on it. Only on home's
/// side, and connected to home, is a pose the one that the legs led to.
class HomeSide {
public:
    /// homeDeterminant: of the scaled Jacobian at home, not 0. The equations must outlive this.
    HomeSide(const LegEquations& equations, double homeDeterminant) noexcept
        : m_equations(equations), m_homeDeterminant(homeDeterminant) {}

    /// The Jacobian's determinant there as a part of home's: positive on home's side.
    double determinantRatio(const Placement& place) const noexcept;
    /// Whether it keeps home's sign along the straight path: the centroid on a line, the rotation about one
    /// axis.
    bool isConnected(const Placement& from, const Placement& to) const noexcept;
    /// Follows the pose while the legs go straight from their lengths at `from` to `target`, in steps that
    /// stay on the side. Nothing where the path meets a singularity. Adds its iterations.
    std::optional<Placement> follow(const Placement& from, const LegEquations::Legs& target, double tolerance,
                                    int& iterations) const noexcept;

private:
    std::optional<Placement> correct(Placement place, const LegEquations::Legs& target, double tolerance,
                                     int& iterations) const noexcept;

    const LegEquations& m_equations;
    double m_homeDeterminant;
};

} // namespace hexapose
