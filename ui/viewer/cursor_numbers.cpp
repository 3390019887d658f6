// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/cursor_numbers.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kGapSteps = 5.0;

} // namespace

std::optional<double> valueAt(const Table& table, const Column& column, double time) {
    const TimeAxis& axis = table.time();
    const auto last = axis.lastAtOrBefore(time);
    if (!last)
        return std::nullopt;
    const double reach = kGapSteps * axis.usualStep();
    const double from = axis.seconds(*last) - reach;
    for (Row row = *last + 1; row-- > 0;) {
        const double at = axis.seconds(row);
        if (at < from || at > time)
            break;
        if (const double value = column.number(row); !std::isnan(value))
            return value;
    }
    return std::nullopt;
}

TimeSpan measuredSpan(const Cursors& cursors, const TimeSpan& view) {
    if (!cursors.a || !cursors.b)
        return view;
    return {std::min(*cursors.a, *cursors.b), std::max(*cursors.a, *cursors.b)};
}

NumbersJob::NumbersJob(QObject* parent) : QObject(parent), m_job(QStringLiteral("statistics")) {}

void NumbersJob::ask(const std::shared_ptr<const Table>& table, const std::vector<Curve>& curves,
                     const TimeSpan& span) {
    m_next = Question{table, curves, span};
    if (m_job.isRunning())
        m_job.cancel();
    else
        start();
}

void NumbersJob::start() {
    const Question question = *std::exchange(m_next, std::nullopt);
    m_job.start(
        [question](const Job& job) {
            std::vector<Statistics> all;
            const auto rows = question.table->time().rowsBetween(question.span.begin, question.span.end);
            for (const Curve& curve : question.curves) {
                if (job.isCancelled())
                    break;
                all.push_back(statisticsOf(*curve.column, rows));
            }
            return all;
        },
        [this, curves = question.curves](const Job::Outcome<std::vector<Statistics>>& outcome) {
            if (outcome.result && outcome.result->size() == curves.size())
                emit ready(*outcome.result, curves);
            if (m_next)
                start();
        });
}

} // namespace hexapose

#include "moc_cursor_numbers.cpp"
