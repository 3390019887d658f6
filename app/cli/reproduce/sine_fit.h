// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace hexapose::reproduce {

/// A polynomial fitted by least squares to a sine over one period, 0 to 2 pi, at equally spaced points.
class SineFit {
public:
    explicit SineFit(int degree);

    double operator()(double x) const;
    int degree() const { return static_cast<int>(m_coefficients.size()) - 1; }
    double largestError() const { return m_largestError; } ///< at the points
    double rmsError() const { return m_rmsError; }

    static constexpr int kPoints = 41;
    static double point(int index); ///< 0 to kPoints - 1

private:
    Eigen::VectorXd m_coefficients; ///< of the powers of (x - pi) / pi
    double m_largestError = 0.0;
    double m_rmsError = 0.0;
};

} // namespace hexapose::reproduce
