// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/published_table5.h"
#include "app/cli/solver_choice.h"
#include "core/geometry/input_error.h"
#include "core/geometry/number_text.h"
#include "core/geometry/units.h"
#include "core/kinematics/forward_methods.h"
#include "core/report/error_report.h"
#include "ui/report/report_export.h"

#include <QFile>
#include <QSaveFile>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace hexapose {

namespace {

namespace fs = std::filesystem;

constexpr const char* kMethods[] = {"newton", "newton-as-published", "mpr2-nr", "mpr3-nr"};

struct Solved {
    std::string method;
    ForwardResult result;
};

LegLengths publishedLengths() {
    LegLengths lengths;
    for (int i = 0; i < kLegCount; ++i)
        lengths[i] = metresFromMm(published::kTable5LengthsMm[static_cast<std::size_t>(i)]);
    return lengths;
}

std::string scientific(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value); // the command line never sets a locale for numbers
    return text;
}

std::string csvTable(const std::vector<Solved>& solved) {
    std::string csv = "coordinate,unit,reference,published";
    for (const Solved& s : solved)
        csv += "," + s.method;
    csv += "\n";
    for (const published::Table5Row& row : published::kTable5) {
        csv += std::string(row.coordinate) + "," + row.unit + "," + formatNumber(row.reference) + "," +
               formatNumber(row.solved);
        for (const Solved& s : solved)
            csv += "," + formatNumber(s.result.pose.toVector()[row.index]);
        csv += "\n";
    }
    return csv;
}

void endLine(std::string& out) {
    out.erase(out.find_last_not_of(' ') + 1);
    out += "\n";
}

void appendCell(std::string& out, const std::string& text, std::size_t width) {
    out += text + std::string(text.size() < width ? width - text.size() : 1, ' ');
}

std::string textTable(const std::vector<Solved>& solved) {
    constexpr std::size_t kNarrow = 12;
    constexpr std::size_t kWide = 21;
    std::string text = "Table 5: the pose of the lengths 339.5 336.5 336.6 329.2 345.1 334.5 mm\n\n";
    appendCell(text, "", kNarrow);
    appendCell(text, "reference", kNarrow);
    appendCell(text, "published", kNarrow);
    for (const Solved& s : solved)
        appendCell(text, s.method, kWide);
    endLine(text);
    for (const published::Table5Row& row : published::kTable5) {
        appendCell(text, std::string(row.coordinate) + " (" + row.unit + ")", kNarrow);
        appendCell(text, scientific(row.reference), kNarrow);
        appendCell(text, scientific(row.solved), kNarrow);
        for (const Solved& s : solved)
            appendCell(text, scientific(s.result.pose.toVector()[row.index]), kWide);
        endLine(text);
    }
    appendCell(text, "iterations", 3 * kNarrow);
    for (const Solved& s : solved)
        appendCell(text, std::to_string(s.result.iterations), kWide);
    endLine(text);
    return text + "\nThe published gamma, 0.0896, is a misprint of 0.0869: two digits are exchanged. Its "
                  "reference, "
                  "5 deg, is 0.08727 rad,\nnot 0.0870.\n";
}

/// Within one unit of the last printed digit, the misprint corrected.
bool agrees(const Solved& solved) {
    bool good = solved.result.status == SolveStatus::Converged;
    for (const published::Table5Row& row : published::kTable5)
        good = good && std::abs(solved.result.pose.toVector()[row.index] - row.corrected) <= row.lastDigit;
    return good;
}

void writeText(const fs::path& file, const std::string& text) {
    QSaveFile out(QString::fromStdString(file.string()));
    const bool written =
        out.open(QIODevice::WriteOnly) &&
        out.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size());
    if (!written || !out.commit())
        throw InputError(file.string(), "cannot be written: " + out.errorString().toStdString());
}

int reproduceTable5(const PlatformGeometry& platform, const fs::path& directory) {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error)
        throw InputError(directory.string(), "cannot be made: " + error.message());
    std::vector<Solved> solved;
    std::vector<SettledSample> samples(1);
    samples[0].target.offset = {0.012, -0.004, 0.040};
    samples[0].target.angles.gamma = radiansFromDeg(5.0);
    samples[0].meanLengths = publishedLengths();
    samples[0].measurements = 1;
    ErrorReport report;
    for (const char* word : kMethods) {
        const std::unique_ptr<ForwardSolver> solver =
            makeDefaultSolver(*findForwardMethod(word), platform).solver;
        solved.push_back({word, solver->solve(publishedLengths(), Pose{})});
        report = makeErrorReport(platform, *solver, samples);
    }
    const std::string text = textTable(solved);
    std::fputs(text.c_str(), stdout);
    writeText(directory / "table5.txt", text);
    writeText(directory / "table5.csv", csvTable(solved));
    exportErrorPictures(report, directory / "table5");
    bool good = true;
    for (const Solved& s : solved) {
        if (agrees(s))
            continue;
        good = false;
        std::fprintf(stderr, "hexapose-cli: table5: %s disagrees with the published values\n",
                     s.method.c_str());
    }
    return good ? kExitDone : kExitSomeFailed;
}

} // namespace

int reproduceCommand(const QStringList& words) {
    const Arguments arguments("reproduce", {QStringLiteral("table5")},
                              {{"out", "DIR", "Directory of the text, CSV and pictures."}}, words);
    const std::string what = arguments.operand(0);
    if (what != "table5")
        throw InputError("reproduce", "'" + what + "' is not available in this version (available: table5)");
    return reproduceTable5(arguments.platform(), arguments.requiredText("out"));
}

} // namespace hexapose
