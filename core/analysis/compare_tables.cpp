// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/analysis/compare_tables.h"

#include "core/table/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapose {

namespace {

constexpr double kPauseSteps = 5.0;
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr int kGrid = 2048;             ///< points of the longer log, for the first search
constexpr std::size_t kMostRows = 4000; ///< of `a`, for the refined search
constexpr int kMostColumns = 6;

/// A column at even steps of time.
std::vector<double> sampled(const Table& table, std::size_t column, double step, int count) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        values.push_back(valueAt(table, column, table.time().begin() + i * step));
    return values;
}

struct Signal {
    CommonColumn column;
    double variance = 0.0;
    std::vector<double> a, b;
};

/// Mean of the squared differences over the variances, of what overlaps when `b` begins `lag` samples later;
/// infinite where that is too little.
double costOf(const std::vector<Signal>& signals, int lag, int least) {
    double cost = 0.0;
    for (const Signal& signal : signals) {
        const int begin = std::max(0, -lag);
        const int end = std::min(static_cast<int>(signal.a.size()), static_cast<int>(signal.b.size()) - lag);
        double sum = 0.0;
        int count = 0;
        for (int i = begin; i < end; ++i) {
            const int j = i + lag;
            const double difference =
                signal.a[static_cast<std::size_t>(i)] - signal.b[static_cast<std::size_t>(j)];
            if (!std::isnan(difference)) {
                sum += difference * difference;
                ++count;
            }
        }
        if (count < least)
            return std::numeric_limits<double>::infinity();
        cost += sum / count / signal.variance;
    }
    return cost;
}

/// The same at rows of `a`, for any shift.
double costAt(const Table& a, const Table& b, const std::vector<Signal>& signals, double shift) {
    const Row stride = std::max<Row>(1, a.rowCount() / kMostRows);
    double cost = 0.0;
    for (const Signal& signal : signals) {
        double sum = 0.0;
        std::size_t count = 0;
        for (Row row = 0; row < a.rowCount(); row += stride) {
            const double difference = a.columns()[signal.column.a].number(row) -
                                      valueAt(b, signal.column.b, a.time().seconds(row) + shift);
            if (!std::isnan(difference)) {
                sum += difference * difference;
                ++count;
            }
        }
        if (count == 0)
            return std::numeric_limits<double>::infinity();
        cost += sum / static_cast<double>(count) / signal.variance;
    }
    return cost;
}

/// Those that change most clearly first: the legs and the pose of a session log are among the first columns.
std::vector<Signal> signalsOf(const Table& a, const std::vector<CommonColumn>& columns) {
    std::vector<Signal> signals;
    for (const CommonColumn column : columns) {
        const Statistics all = statisticsOf(a.columns()[column.a], 0, a.rowCount());
        if (all.count > 2 && all.sigma > 1e-9 * std::abs(all.mean) &&
            static_cast<int>(signals.size()) < kMostColumns)
            signals.push_back({column, all.sigma * all.sigma, {}, {}});
    }
    return signals;
}

} // namespace

std::vector<CommonColumn> commonColumns(const Table& a, const Table& b) {
    std::vector<CommonColumn> common;
    for (std::size_t i = 0; i < a.columns().size(); ++i) {
        const ColumnInfo& info = a.columns()[i].info();
        const auto other = b.find(info.name);
        if (a.columns()[i].isNumber() && other && b.columns()[*other].isNumber() &&
            b.columns()[*other].info().unit == info.unit)
            common.push_back({i, *other});
    }
    return common;
}

double valueAt(const Table& table, std::size_t column, double seconds) {
    const TimeAxis& time = table.time();
    const std::optional<Row> before = time.lastAtOrBefore(seconds);
    if (!before)
        return kNoValue;
    const double value = table.columns()[column].number(*before), at = time.seconds(*before);
    if (at == seconds)
        return value;
    const Row next = *before + 1;
    if (next >= table.rowCount() || !(time.seconds(next) > at) ||
        (time.usualStep() > 0.0 && time.seconds(next) - at > kPauseSteps * time.usualStep()))
        return kNoValue;
    const double part = (seconds - at) / (time.seconds(next) - at);
    return value + part * (table.columns()[column].number(next) - value);
}

std::optional<double> timeOfEvent(const Table& table, std::string_view text) {
    const auto column = table.find("event");
    if (!column || table.columns()[*column].info().kind != CellKind::Word)
        return std::nullopt;
    for (Row row = 0; row < table.rowCount(); ++row)
        if (table.columns()[*column].word(row).find(text) != std::string_view::npos)
            return table.time().seconds(row);
    return std::nullopt;
}

std::optional<double> findShift(const Table& a, const Table& b, const std::vector<CommonColumn>& columns) {
    std::vector<Signal> signals = signalsOf(a, columns);
    if (signals.empty() || b.rowCount() < 3)
        return std::nullopt;
    const double spanA = a.time().end() - a.time().begin(), spanB = b.time().end() - b.time().begin();
    const double step =
        std::max({std::max(spanA, spanB) / kGrid, a.time().usualStep(), b.time().usualStep(), 1e-12});
    const int countA = static_cast<int>(spanA / step) + 1, countB = static_cast<int>(spanB / step) + 1;
    for (Signal& signal : signals) {
        signal.a = sampled(a, signal.column.a, step, countA);
        signal.b = sampled(b, signal.column.b, step, countB);
    }
    const int least = std::max(2, std::min(countA, countB) / 2);
    const int none =
        static_cast<int>(std::lround((a.time().begin() - b.time().begin()) / step)); // no shift at all
    int best = none;
    double bestCost = costOf(signals, none, least);
    for (int lag = -countA; lag <= countB; ++lag) {
        const double cost = costOf(signals, lag, least);
        if (cost < bestCost * (1.0 - 1e-9)) {
            best = lag;
            bestCost = cost;
        }
    }
    if (!std::isfinite(bestCost))
        return std::nullopt;
    // Golden section about it.
    const double base = b.time().begin() - a.time().begin();
    double low = base + (best - 1) * step, high = base + (best + 1) * step;
    const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
    double left = high - ratio * (high - low), right = low + ratio * (high - low);
    double atLeft = costAt(a, b, signals, left), atRight = costAt(a, b, signals, right);
    while (high - low > 1e-6 * step) {
        if (atLeft < atRight) {
            high = right;
            right = left;
            atRight = atLeft;
            left = high - ratio * (high - low);
            atLeft = costAt(a, b, signals, left);
        } else {
            low = left;
            left = right;
            atLeft = atRight;
            right = low + ratio * (high - low);
            atRight = costAt(a, b, signals, right);
        }
    }
    const double shift = 0.5 * (low + high);
    // The search ends a little beside a round number, and beside a whole number of samples.
    const double found = costAt(a, b, signals, shift);
    std::vector<double> exact{0.0, base + best * step};
    for (double unit = 1.0; unit > 1e-10; unit /= 10.0)
        exact.push_back(std::round(shift / unit) * unit);
    for (const double candidate : exact)
        if (std::abs(candidate - shift) < step && costAt(a, b, signals, candidate) <= found)
            return candidate;
    return shift;
}

ColumnDifference compareColumn(const Table& a, const Table& b, CommonColumn column, double shift) {
    ColumnDifference result;
    double squares = 0.0;
    for (Row row = 0; row < a.rowCount(); ++row) {
        const double seconds = a.time().seconds(row);
        const double difference = valueAt(b, column.b, seconds + shift) - a.columns()[column.a].number(row);
        if (std::isnan(difference))
            continue;
        ++result.count;
        squares += difference * difference;
        if (std::abs(difference) > std::abs(result.largest)) {
            result.largest = difference;
            result.largestAt = seconds;
        }
    }
    result.rms = result.count > 0 ? std::sqrt(squares / static_cast<double>(result.count)) : 0.0;
    return result;
}

} // namespace hexapose
