// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/sine_fit.h"

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
    const Eigen::Index count = degree + 1;
    Eigen::MatrixXd x(kPoints, count);
    Eigen::VectorXd y(kPoints);
    for (int i = 0; i < kPoints; ++i) {
        x.row(i) = powers(point(i), count).transpose();
        y[i] = std::sin(point(i));
    }
    // Least squares by Gram and Schmidt, x = q r: so few columns do not need Eigen/QR, which takes four times
    // as long to compile as all of this file.
    Eigen::MatrixXd q = x;
    Eigen::MatrixXd r = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd error = y;
    m_coefficients = Eigen::VectorXd::Zero(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        for (Eigen::Index before = 0; before < k; ++before) {
            r(before, k) = q.col(before).dot(q.col(k));
            q.col(k) -= r(before, k) * q.col(before);
        }
        r(k, k) = q.col(k).norm();
        q.col(k) /= r(k, k);
        m_coefficients[k] = q.col(k).dot(error);
        error -= m_coefficients[k] * q.col(k);
    }
    for (Eigen::Index k = count; k-- > 0;) {
        m_coefficients[k] /= r(k, k);
        m_coefficients.head(k) -= m_coefficients[k] * r.col(k).head(k);
    }
    error = x * m_coefficients - y;
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
