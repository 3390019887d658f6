// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/statistics.h"
#include "ui/common/job.h"
#include "ui/viewer/log_chart.h"

#include <QObject>

#include <vector>

namespace hexapose {

/// The value at or before a time: of the last row that has one, if that is no further back than a gap.
std::optional<double> valueAt(const Table& table, const Column& column, double time);

/// The span that the statistics are of.
TimeSpan measuredSpan(const Cursors& cursors, const TimeSpan& view);

/// Works out the statistics beside the screen: what is asked for last is what comes.
class NumbersJob final : public QObject {
    Q_OBJECT
public:
    explicit NumbersJob(QObject* parent = nullptr);
    void ask(const std::shared_ptr<const Table>& table, const std::vector<Curve>& curves,
             const TimeSpan& span);

signals:
    void ready(const std::vector<hexapose::Statistics>& statistics,
               const std::vector<hexapose::Curve>& curves);

private:
    struct Question {
        std::shared_ptr<const Table> table;
        std::vector<Curve> curves;
        TimeSpan span;
    };
    void start();

    std::optional<Question> m_next;
    Job m_job;
};

} // namespace hexapose
