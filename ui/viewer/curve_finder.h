// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewer/chart_layout.h"

#include <map>

namespace hexapose {

/// A curve of a table: its numbers.
struct Curve {
    CurveSpec spec;
    std::shared_ptr<const Column> column;
};

/// The curves of a table that may still grow. Differences are worked out when they are first asked for, and
/// only for the rows that came since later on.
class CurveFinder {
public:
    void follow(const std::shared_ptr<const Table>& table);
    const std::shared_ptr<const Table>& table() const { return m_table; }
    /// Nothing where the table lacks it, or it is no number.
    std::optional<Curve> find(const CurveSpec& spec);
    /// Those of a chart that there are.
    std::vector<Curve> find(const ChartSpec& chart);

private:
    struct Difference {
        Chunked<double> numbers;
        MinMaxPyramid pyramid;
        Row rows = 0;
        std::shared_ptr<const Column> column;
    };
    std::shared_ptr<const Column> plain(const QString& name) const;
    std::shared_ptr<const Column> difference(const CurveSpec& spec);

    std::shared_ptr<const Table> m_table = std::make_shared<Table>();
    std::map<QString, Difference> m_differences; ///< by the name of the curve
};

} // namespace hexapose
