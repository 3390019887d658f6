// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

/// Tables 2, 3 and 4 of Applied Sciences 2023, 13, 3082, as printed.
namespace hexapose::published {

enum class Algorithm { Newton, Mpr2, Mpr3, Mpr2Newton, Mpr3Newton };

/// The stop test of Tables 2 and 3: norm of the leg errors, m; and the most iterations.
inline constexpr double kTolerance = 1e-3;
inline constexpr int kMaxIterations = 10;
/// Poses that the regression is fitted to, and poses that everything is tested on.
inline constexpr int kTrainingPoses = 100000;
inline constexpr int kTestPoses = 10000;
/// Set 1 and set 2: +- mm and +- degrees.
inline constexpr std::array<double, 2> kSetRange{10.0, 40.0};

/// Mean absolute errors over one set of test poses, and what the solutions took.
struct ErrorRow {
    Algorithm algorithm;
    int set;
    std::array<const char*, 6> digits; ///< alpha beta gamma (rad), x y z (m), before the power of ten
    int exponent;
    double matlabSeconds;  ///< for 10,000 solutions, MATLAB on an i7-8750H
    int iterations = -1;   ///< total of 10,000 solutions; -1: not printed
    bool misprint = false; ///< the errors cannot be right
};

inline constexpr std::array<ErrorRow, 6> kTable2{{
    {Algorithm::Newton, 1, {"0.3", "0.2", "1.7", "0.4", "0.4", "0.2"}, -5, 1.144},
    {Algorithm::Newton, 2, {"0.3", "0.1", "0.6", "0.05", "0.05", "0.03"}, -3, 1.815},
    {Algorithm::Mpr2, 1, {"3.4", "1.7", "2.8", "0.4", "0.5", "0.2"}, -4, 0.169},
    {Algorithm::Mpr2, 2, {"2.2", "1.0", "1.8", "0.2", "0.3", "0.1"}, -2, 0.164},
    {Algorithm::Mpr3, 1, {"1.8", "1.9", "2.6", "0.3", "0.2", "0.2"}, -5, 0.287},
    {Algorithm::Mpr3, 2, {"5.1", "3.5", "6.4", "0.6", "0.5", "0.3"}, -3, 0.272},
}};

/// The first row shows other errors than the first row of Table 2, which is the same method on the same
/// poses in the same time. Table 2 is the one that can be reproduced.
inline constexpr std::array<ErrorRow, 6> kTable3{{
    {Algorithm::Newton, 1, {"3.2", "2.7", "12.5", "3.2", "3.0", "1.4"}, -5, 1.144, 26710, true},
    {Algorithm::Newton, 2, {"0.3", "0.1", "0.6", "0.05", "0.05", "0.03"}, -3, 1.815, 41664},
    {Algorithm::Mpr2Newton, 1, {"3.4", "1.7", "2.8", "0.4", "0.5", "0.2"}, -4, 0.296, 0},
    {Algorithm::Mpr2Newton, 2, {"0.3", "0.1", "0.6", "0.05", "0.05", "0.03"}, -3, 1.284, 26019},
    {Algorithm::Mpr3Newton, 1, {"1.8", "1.9", "2.7", "0.3", "0.2", "0.2"}, -5, 0.407, 0},
    {Algorithm::Mpr3Newton, 2, {"0.4", "0.3", "0.7", "0.07", "0.07", "0.04"}, -3, 1.162, 16998},
}};

/// Set 2. D(L): norm of the leg errors at which the iteration stops, m. D(X): mean Euclidean distance of the
/// pose vectors, rad and m mixed. MPR-NR is the cubic one.
struct StopRow {
    double tolerance;
    double newtonDistance, newtonIterations;
    double mprDistance, mprIterations;
};

inline constexpr std::array<StopRow, 8> kTable4{{
    {1e-3, 7.00e-4, 4.16, 1.20e-3, 1.70},
    {1e-4, 7.59e-5, 5.53, 7.19e-5, 3.18},
    {1e-5, 7.81e-6, 6.91, 7.74e-6, 4.50},
    {1e-6, 7.96e-7, 8.31, 7.93e-7, 5.89},
    {1e-7, 8.01e-8, 9.71, 8.07e-8, 7.28},
    {1e-8, 7.99e-9, 11.12, 8.09e-9, 8.69},
    {1e-9, 7.99e-10, 12.53, 8.01e-10, 10.10},
    {1e-10, 8.03e-11, 13.94, 7.98e-11, 11.51},
}};

} // namespace hexapose::published
