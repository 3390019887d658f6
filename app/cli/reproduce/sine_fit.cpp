// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/sine_fit.h"

#include <Eigen/QR>

#include <cmath>
#include <numbers>

namespace hexapose::reproduce {

namespace {

Eigen::VectorXd powers(double x, Eigen::Index count) {
    const double u = (x - std::numbers::pi) / std::numbers::pi;
    Eigen::VectorXd row(count);
    double power = 1.0;
    for (Eigen::Index i = 0; i < count; ++i, power *= u)
        row[i] = power;
    return row;
}

} // namespace

SineFit::SineFit(int degree) {
    Eigen::MatrixXd x(kPoints, degree + 1);
    Eigen::VectorXd y(kPoints);
    for (int i = 0; i < kPoints; ++i) {
        x.row(i) = powers(point(i), degree + 1).transpose();
        y[i] = std::sin(point(i));
    }
    m_coefficients = x.householderQr().solve(y);
    const Eigen::VectorXd error = x * m_coefficients - y;
    m_largestError = error.cwiseAbs().maxCoeff();
    m_rmsError = error.norm() / std::sqrt(static_cast<double>(kPoints));
}

double SineFit::operator()(double x) const {
    return powers(x, m_coefficients.size()).dot(m_coefficients);
}

double SineFit::point(int index) {
    return 2.0 * std::numbers::pi * index / (kPoints - 1);
}

} // namespace hexapose::reproduce
