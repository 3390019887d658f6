// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/drive_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hexapose {

namespace {

constexpr std::size_t kNeighbours = 7;

/// Weights of samples at `times` for value, first and second derivative at `at` of the polynomial through
/// them, by Fornberg's recursion (Math. Comp. 51, 1988, 699).
using Weights = std::array<std::array<double, kNeighbours>, 3>;
Weights derivativeWeights(std::span<const double> times, double at) {
    Weights weights{};
    weights[0][0] = 1.0;
    double product = 1.0;
    double offset = times[0] - at;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const std::size_t most = std::min<std::size_t>(i, 2);
        const double before = offset;
        double next = 1.0;
        offset = times[i] - at;
        for (std::size_t j = 0; j < i; ++j) {
            const double gap = times[i] - times[j];
            next *= gap;
            if (j == i - 1)
                for (std::size_t k = most + 1; k-- > 0;) {
                    const double lower = k > 0 ? static_cast<double>(k) * weights[k - 1][i - 1] : 0.0;
                    weights[k][i] = product * (lower - before * weights[k][i - 1]) / next;
                }
            for (std::size_t k = most + 1; k-- > 0;) {
                const double lower = k > 0 ? static_cast<double>(k) * weights[k - 1][j] : 0.0;
                weights[k][j] = (offset * weights[k][j] - lower) / gap;
            }
        }
        product = next;
    }
    return weights;
}

/// Polynomial of degree 5 on [0, 1] with these values, first and second derivatives at both ends; value,
/// first and second derivative at s.
std::array<double, 3> hermite(const std::array<double, 3>& left, const std::array<double, 3>& right,
                              double s) noexcept {
    const double rise = right[0] - left[0] - left[1] - 0.5 * left[2];
    const double slope = right[1] - left[1] - left[2];
    const double bend = right[2] - left[2];
    const std::array<double, 6> c{left[0],
                                  left[1],
                                  0.5 * left[2],
                                  10.0 * rise - 4.0 * slope + 0.5 * bend,
                                  -15.0 * rise + 7.0 * slope - bend,
                                  6.0 * rise - 3.0 * slope + 0.5 * bend};
    std::array<double, 3> result{};
    for (std::size_t k = c.size(); k-- > 0;) {
        result[2] = result[2] * s + 2.0 * result[1];
        result[1] = result[1] * s + result[0];
        result[0] = result[0] * s + c[k];
    }
    return result;
}

} // namespace

StraightDrive::StraightDrive(Eigen::VectorXd from, Eigen::VectorXd to)
    : m_from(std::move(from)), m_to(std::move(to)) {}

void StraightDrive::at(double time, std::span<DriveState> states) const noexcept {
    for (std::size_t i = 0; i < states.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const double change = m_to[k] - m_from[k];
        states[i] = {time == 1.0 ? m_to[k] : m_from[k] + time * change, change, 0.0};
    }
}

ReferenceDrive::ReferenceDrive(const Mechanism& mechanism, double duration) : m_duration(duration) {
    for (const Actuator& actuator : mechanism.actuators)
        m_waves.push_back(
            {homeValue(mechanism, actuator), actuator.referenceAmplitude, actuator.referenceRate});
}

void ReferenceDrive::at(double time, std::span<DriveState> states) const noexcept {
    for (std::size_t i = 0; i < states.size(); ++i) {
        const auto& [middle, amplitude, rate] = m_waves[i];
        const double sine = amplitude * std::sin(rate * time);
        states[i] = {middle + sine, amplitude * rate * std::cos(rate * time), -rate * rate * sine};
    }
}

TableDrive::TableDrive(Samples samples) : m_samples(std::move(samples)) {
    if (m_samples.withRates)
        return;
    const std::vector<double>& times = m_samples.times;
    const std::size_t used = std::min(kNeighbours, times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        const std::size_t centred = i < used / 2 ? 0 : i - used / 2;
        const std::size_t first = std::min(centred, times.size() - used);
        const Weights weights = derivativeWeights(std::span(times).subspan(first, used), times[i]);
        for (std::vector<DriveState>& states : m_samples.states) {
            states[i].rate = states[i].acceleration = 0.0;
            for (std::size_t j = 0; j < used; ++j) {
                states[i].rate += weights[1][j] * states[first + j].value;
                states[i].acceleration += weights[2][j] * states[first + j].value;
            }
        }
    }
}

void TableDrive::at(double time, std::span<DriveState> states) const noexcept {
    const std::vector<double>& times = m_samples.times;
    const auto above = std::upper_bound(times.begin() + 1, times.end() - 1, time);
    const auto right = static_cast<std::size_t>(above - times.begin());
    const double width = times[right] - times[right - 1];
    const auto scaled = [width](const DriveState& state) {
        return std::array{state.value, width * state.rate, width * width * state.acceleration};
    };
    const double s = std::clamp((time - times[right - 1]) / width, 0.0, 1.0);
    for (std::size_t i = 0; i < states.size(); ++i) {
        const auto value =
            hermite(scaled(m_samples.states[i][right - 1]), scaled(m_samples.states[i][right]), s);
        states[i] = {value[0], value[1] / width, value[2] / (width * width)};
    }
}

} // namespace hexapose
