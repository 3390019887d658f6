// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/chart_layout.h"

#include "core/base/input_error.h"
#include "ui/viewer/qt_text.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace hexapose {

namespace {

constexpr std::size_t kForeignCurves = 6; ///< of a file whose columns say nothing to us
constexpr int kTitleCurves = 3;
constexpr int kVersion = 1;
const QString kVersionKey = QStringLiteral("hexapose-layout");
const QString kChartsKey = QStringLiteral("charts");
const QString kNameKey = QStringLiteral("name");
const QString kCurvesKey = QStringLiteral("curves");
const QString kColumnKey = QStringLiteral("column");
const QString kMinusKey = QStringLiteral("minus");

bool hasNumbers(const Table& table, const QString& name) {
    const auto index = table.find(name.toStdString());
    return index && table.columns()[*index].isNumber();
}

std::vector<CurveSpec> legCurves() {
    std::vector<CurveSpec> curves;
    for (int leg = 1; leg <= 6; ++leg)
        curves.push_back({QStringLiteral("l%1_mm").arg(leg), {}});
    return curves;
}

/// Each minus the path that was asked for.
std::vector<CurveSpec> poseCurves(const QStringList& coordinates, const QString& unit, bool minusPath) {
    std::vector<CurveSpec> curves;
    for (const QString& one : coordinates)
        curves.push_back({one + unit, minusPath ? one + QStringLiteral("_path") + unit : QString()});
    return curves;
}

std::vector<ChartSpec> logCharts() {
    const QStringList offsets{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    const QStringList angles{QStringLiteral("alpha"), QStringLiteral("beta"), QStringLiteral("gamma")};
    const QString mm = QStringLiteral("_mm"), deg = QStringLiteral("_deg");
    return {{QStringLiteral("position"), poseCurves(offsets, mm, false)},
            {QStringLiteral("angles"), poseCurves(angles, deg, false)},
            {QStringLiteral("legs"), legCurves()},
            {QStringLiteral("position error"), poseCurves(offsets, mm, true)},
            {QStringLiteral("angle error"), poseCurves(angles, deg, true)},
            {QStringLiteral("residual"), {{QStringLiteral("residual_mm"), {}}}},
            {QStringLiteral("q"), {{QStringLiteral("q"), {}}}}};
}

ChartSpec foreignChart(const Table& table) {
    ChartSpec chart{QStringLiteral("columns"), {}};
    const auto& columns = table.columns();
    for (std::size_t i = 0; i < columns.size() && chart.curves.size() < kForeignCurves; ++i)
        if (columns[i].isNumber() && table.time().column() != i)
            chart.curves.push_back({toQt(columns[i].info().name), {}});
    return chart;
}

} // namespace

QString CurveSpec::name() const {
    return minus.isEmpty() ? column : column + QStringLiteral(" - ") + minus;
}

QString ChartSpec::title() const {
    const std::pair<const char*, QString> known[] = {
        {"position", ChartWords::tr("Position")},
        {"angles", ChartWords::tr("Angles")},
        {"legs", ChartWords::tr("Legs")},
        {"position error", ChartWords::tr("Position error")},
        {"angle error", ChartWords::tr("Angle error")},
        {"residual", ChartWords::tr("Residual")},
        {"columns", ChartWords::tr("Columns of the file")},
    };
    for (const auto& [word, text] : known)
        if (name == QLatin1String(word))
            return text;
    if (!name.isEmpty())
        return name;
    QStringList names;
    for (const CurveSpec& curve : curves)
        if (names.size() < kTitleCurves)
            names.append(curve.name());
        else if (names.size() == kTitleCurves)
            names.append(QStringLiteral("..."));
    return names.isEmpty() ? ChartWords::tr("Empty") : names.join(QStringLiteral(", "));
}

ChartLayout defaultLayout(const Table& table) {
    ChartLayout layout;
    for (ChartSpec chart : logCharts()) {
        std::erase_if(chart.curves, [&](const CurveSpec& curve) {
            return !hasNumbers(table, curve.column) ||
                   (!curve.minus.isEmpty() && !hasNumbers(table, curve.minus));
        });
        if (!chart.curves.empty())
            layout.charts.push_back(chart);
    }
    if (layout.charts.empty())
        layout.charts.push_back(foreignChart(table));
    return layout;
}

ChartLayout chosenCharts(const ChartLayout& layout, const Table& table,
                         const std::vector<std::string>& names) {
    ChartLayout chosen;
    for (const std::string& word : names) {
        const QString name = toQt(word);
        const auto same = [&](const ChartSpec& chart) {
            return chart.name.compare(name, Qt::CaseInsensitive) == 0 ||
                   chart.title().compare(name, Qt::CaseInsensitive) == 0;
        };
        const auto chart = std::find_if(layout.charts.begin(), layout.charts.end(), same);
        if (chart != layout.charts.end())
            chosen.charts.push_back(*chart);
        else if (hasNumbers(table, name))
            chosen.charts.push_back({{}, {{name, {}}}});
        else
            throw InputError(word, "neither a chart nor a column of numbers in " + table.sourceName());
    }
    return chosen;
}

QByteArray formatLayout(const ChartLayout& layout) {
    QJsonArray charts;
    for (const ChartSpec& chart : layout.charts) {
        QJsonArray curves;
        for (const CurveSpec& curve : chart.curves) {
            QJsonObject one{{kColumnKey, curve.column}};
            if (!curve.minus.isEmpty())
                one.insert(kMinusKey, curve.minus);
            curves.append(one);
        }
        charts.append(QJsonObject{{kNameKey, chart.name}, {kCurvesKey, curves}});
    }
    return QJsonDocument(QJsonObject{{kVersionKey, kVersion}, {kChartsKey, charts}}).toJson();
}

ChartLayout parseLayout(const QByteArray& text, const std::string& sourceName) {
    QJsonParseError error{};
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError)
        throw InputError(sourceName, "not a layout: " + error.errorString().toStdString());
    if (document.object().value(kVersionKey).toInt() != kVersion)
        throw InputError(sourceName, "not a layout of charts");
    ChartLayout layout;
    for (const QJsonValue& one : document.object().value(kChartsKey).toArray()) {
        ChartSpec chart{one[kNameKey].toString(), {}};
        for (const QJsonValue& curve : one[kCurvesKey].toArray()) {
            const CurveSpec spec{curve[kColumnKey].toString(), curve[kMinusKey].toString()};
            if (spec.column.isEmpty())
                throw InputError(sourceName, "a curve names no column");
            chart.curves.push_back(spec);
        }
        layout.charts.push_back(chart);
    }
    if (layout.charts.empty())
        throw InputError(sourceName, "no chart in this layout");
    return layout;
}

ChartLayout loadLayout(const QString& file) {
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly))
        throw InputError(file.toStdString(), "cannot be read: " + in.errorString().toStdString());
    return parseLayout(in.readAll(), file.toStdString());
}

} // namespace hexapose
