// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace hexapose {

/// What one curve shows: a column, or how far it is from another one.
struct CurveSpec {
    QString column; ///< by its name, else by its label
    QString minus;  ///< empty: none

    QString name() const; ///< "x_mm", "x_mm - x_path_mm"
    bool operator==(const CurveSpec&) const = default;
};

/// One chart. Its name is a word of the layout: "legs", or any text; empty: named by its curves.
struct ChartSpec {
    QString name;
    std::vector<CurveSpec> curves;

    QString title() const; ///< in the language of the screen
    bool operator==(const ChartSpec&) const = default;
};

/// The charts of a page, without any data.
struct ChartLayout {
    std::vector<ChartSpec> charts;
    bool operator==(const ChartLayout&) const = default;
};

/// What a log is shown in at first: pose, legs, errors, residual and q as far as it has them; of a foreign
/// file its first columns of numbers.
ChartLayout defaultLayout(const Table& table);

/// The charts of that name, and else a chart of the column of that name. Throws InputError for a name that
/// is neither.
ChartLayout chosenCharts(const ChartLayout& layout, const Table& table,
                         const std::vector<std::string>& names);

/// As a text file, and back. Throws InputError for what is no layout.
QByteArray formatLayout(const ChartLayout& layout);
ChartLayout parseLayout(const QByteArray& text, const std::string& sourceName);
ChartLayout loadLayout(const QString& file);

/// For the texts of layouts.
struct ChartWords {
    Q_DECLARE_TR_FUNCTIONS(ChartWords)
};

} // namespace hexapose
