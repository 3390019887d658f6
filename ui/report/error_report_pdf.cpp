// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/error_report_pdf.h"

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "ui/report/pdf_pages.h"
#include "ui/report/report_export.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_words.h"

#include <QLocale>

#include <array>
#include <cmath>

namespace hexapose {

namespace {

/// As the field prints them: angles first.
constexpr std::array<int, 6> kPrintOrder{3, 4, 5, 0, 1, 2};
const std::array<QString, 6> kNames{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z"),
                                    QStringLiteral("α"), QStringLiteral("β"), QStringLiteral("γ")};
constexpr double kGapBelowSample = 4.0; // mm
constexpr double kLinesAboveTable = 11.0;

QString resolutionText(const ErrorReport& report) {
    return QString::fromStdString(formatNumber(mmFromMetres(report.resolution))) + QStringLiteral(" mm");
}

QString dateText(const QDateTime& date) {
    const int minutes = date.offsetFromUtc() / 60;
    const QString offset = QStringLiteral("UTC%1%2:%3")
                               .arg(minutes < 0 ? QLatin1Char('-') : QLatin1Char('+'))
                               .arg(std::abs(minutes) / 60, 2, 10, QLatin1Char('0'))
                               .arg(std::abs(minutes) % 60, 2, 10, QLatin1Char('0'));
    return QLocale::c().toString(date, QStringLiteral("yyyy-MM-dd HH:mm:ss ")) + offset;
}

QStringList statisticsRow(const QString& name, const PoseVector& values, const PoseDecimals* common) {
    QStringList cells{name};
    for (const int k : kPrintOrder)
        cells << (common == nullptr ? errorText(values[k]) : common->commonError(k, values[k]));
    return cells;
}

QString statusText(SolveStatus status) {
    switch (status) {
    case SolveStatus::Converged:
        return ReportWords::tr("converged");
    case SolveStatus::IterationLimit:
        return ReportWords::tr("iteration limit reached");
    case SolveStatus::Singular:
        return ReportWords::tr("singular");
    case SolveStatus::NoSolution:
        return ReportWords::tr("no pose of these lengths found");
    case SolveStatus::InvalidInput:
        return ReportWords::tr("invalid lengths");
    case SolveStatus::OutsideModel:
        return ReportWords::tr("outside the model's range");
    case SolveStatus::OtherBranch:
        return ReportWords::tr("pose of another assembly mode");
    }
    return {};
}

/// The standard deviation that the resolution explains over all samples together.
PoseVector typicalSigma(const ErrorReport& report) {
    PoseVector squares = PoseVector::Zero();
    for (const ErrorRow& row : report.rows)
        squares += row.predictedSigma.cwiseAbs2();
    return (squares / static_cast<double>(report.rows.size())).cwiseSqrt();
}

PdfPages::Table statisticsTable(const ErrorReport& report) {
    const PoseDecimals decimals(report);
    PdfPages::Table table;
    table.widths = {50, 21, 21, 21, 21, 21, 21};
    for (const bool si : {true, false}) {
        const PoseDecimals* common = si ? nullptr : &decimals;
        QStringList units{si ? ReportWords::tr("Error in rad and m")
                             : ReportWords::tr("Error in deg and mm")};
        for (const int k : kPrintOrder)
            units << kNames[static_cast<std::size_t>(k)] +
                         (k < 3 ? (si ? QStringLiteral(" (m)") : QStringLiteral(" (mm)"))
                                : (si ? QStringLiteral(" (rad)") : QStringLiteral(" (deg)")));
        if (si)
            table.header = units;
        else
            table.rows.push_back(units);
        table.rows.push_back(statisticsRow(ReportWords::tr("Mean"), report.statistics.mean, common));
        table.rows.push_back(statisticsRow(ReportWords::tr("RMS"), report.statistics.rms, common));
        table.rows.push_back(statisticsRow(ReportWords::tr("Maximum"), report.statistics.maximum, common));
        table.rows.push_back(
            statisticsRow(ReportWords::tr("Predicted std. deviation"), typicalSigma(report), common));
        table.rows.push_back(
            statisticsRow(ReportWords::tr("Predicted bound"), largestPredictedBound(report), common));
    }
    table.headerRows = {5};
    return table;
}

PdfPages::Table sampleTable(const ErrorRow& row, const PoseDecimals& decimals) {
    PdfPages::Table table;
    table.widths = {8, 21, 21, 21, 21, 21, 21, 21, 21};
    table.headerSpan = {4, 4};
    table.groups = QStringList{ReportWords::tr("rad and m"), ReportWords::tr("deg and mm")};
    const QStringList columns{ReportWords::tr("Target"), ReportWords::tr("Solved"), ReportWords::tr("Error"),
                              ReportWords::tr("Predicted")};
    table.header = QStringList{QString()} + columns + columns;
    const bool usable = row.solution.isUsable();
    const PoseVector unknown = PoseVector::Constant(std::nan(""));
    const PoseVector target = row.sample.target.toVector();
    const PoseVector solved = usable ? row.solution.pose.toVector() : unknown;
    const PoseVector error = usable ? row.error : unknown;
    for (const int k : kPrintOrder) {
        table.rows.push_back({kNames[static_cast<std::size_t>(k)], decimals.si(k, target[k]),
                              decimals.si(k, solved[k]), errorText(error[k]),
                              errorText(row.predictedBound[k]), decimals.common(k, target[k]),
                              decimals.common(k, solved[k]), decimals.commonError(k, error[k]),
                              decimals.commonError(k, row.predictedBound[k])});
    }
    return table;
}

double sampleHeight() {
    PdfPages::Table table;
    table.groups = QStringList{QString()};
    table.rows.resize(6);
    return kLinesAboveTable + PdfPages::tableHeight(table) + kGapBelowSample;
}

constexpr double kSamplesHeading = 10.0; // mm

int samplesPerPage() {
    return static_cast<int>((PdfPages::pageHeight() - kSamplesHeading + kGapBelowSample) / sampleHeight());
}

int pageCount(const ErrorReport& report) {
    const int samples = static_cast<int>(report.rows.size());
    return 1 + (samples + samplesPerPage() - 1) / samplesPerPage();
}

void paintFirstPage(PdfPages& pages, const ErrorReport& report, const QDateTime& date) {
    pages.heading(ReportWords::tr("Forward kinematics error report"), 17.0);
    pages.rule();
    pages.skip(2.5);
    constexpr double kLabel = 34.0;
    const auto samples = static_cast<int>(report.rows.size());
    pages.line(ReportWords::tr("Platform"), kLabel, QString::fromStdString(report.platformName));
    pages.line(ReportWords::tr("Solver"), kLabel, QString::fromStdString(report.solver));
    pages.line(ReportWords::tr("Date"), kLabel, dateText(date));
    pages.line(ReportWords::tr("Samples"), kLabel,
               report.failed == 0
                   ? QString::number(samples)
                   : ReportWords::tr("%1, of which %2 without a usable solution and not in the statistics")
                         .arg(samples)
                         .arg(report.failed));
    pages.line(ReportWords::tr("Length resolution"), kLabel, resolutionText(report));
    pages.skip(3.0);
    pages.table(statisticsTable(report));
    pages.skip(1.5);
    pages.note(ReportWords::tr(
                   "Error: solved pose minus target. Maximum: of the absolute value. Predicted: what lengths "
                   "rounded to %1 explain by themselves, through the inverse of the Jacobian; the bound is "
                   "the worst case, the largest of all samples.")
                   .arg(resolutionText(report)),
               2);
    pages.skip(5.0);
    const QRectF figure = pages.take(std::min(pages.remaining(), 142.0));
    paintErrorPanels(pages.painter(), figure, report);
}

void paintSample(PdfPages& pages, const ErrorRow& row, const PoseDecimals& decimals) {
    const ForwardResult& solution = row.solution;
    pages.line(ReportWords::tr("Sample %1").arg(row.number), 24.0,
               ReportWords::tr("%1, iterations: %2, residual: %3 mm, measurements averaged: %4")
                   .arg(statusText(solution.status))
                   .arg(solution.iterations)
                   .arg(errorText(mmFromMetres(solution.residual)))
                   .arg(row.sample.measurements));
    QStringList lengths;
    for (const double length : row.sample.meanLengths)
        lengths << decimals.common(0, length);
    pages.line(QString(), 24.0, ReportWords::tr("Lengths (mm): %1").arg(lengths.join(QStringLiteral("  "))));
    pages.skip(kLinesAboveTable - 2 * PdfPages::lineHeight());
    pages.table(sampleTable(row, decimals));
    pages.skip(kGapBelowSample);
}

} // namespace

void writeErrorReportPdf(const ErrorReport& report, const QDateTime& date, QIODevice& device) {
    const QString title = ReportWords::tr("Forward kinematics error report");
    PdfPages pages(device, title, title + QStringLiteral(" — ") + QString::fromStdString(report.platformName),
                   pageCount(report));
    paintFirstPage(pages, report, date);
    const PoseDecimals decimals(report);
    int onPage = samplesPerPage();
    for (const ErrorRow& row : report.rows) {
        if (onPage == samplesPerPage()) {
            pages.newPage();
            pages.heading(ReportWords::tr("Samples"), 12.0);
            pages.skip(pages.remaining() - (PdfPages::pageHeight() - kSamplesHeading));
            onPage = 0;
        }
        paintSample(pages, row, decimals);
        ++onPage;
    }
}

} // namespace hexapose
