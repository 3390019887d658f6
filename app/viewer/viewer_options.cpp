// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewer/viewer_options.h"

#include "app/common/arguments.h"
#include "core/base/input_error.h"
#include "ui/common/language.h"
#include "ui/viewer/chart_export.h"

namespace hexapose {

Usage viewerUsage() {
    Usage usage{
        "hexapose-viewer",
        {},
        {{"export", "FILE",
          "Without a display: write the charts as FILE.png, FILE.svg or FILE.pdf, or the rows as FILE.csv."},
         {"from", "S", "Show the time from S seconds on."},
         {"to", "S", "Show the time up to S seconds."},
         {"charts", "A,B", "Show these charts alone, by their names, or columns of numbers."},
         {"layout", "FILE", "Show the charts of a layout that was saved."},
         {"language", "CODE", "en or zh_CN (default: the desktop's)."},
         {"theme", "light|dark", "Look of the window (default: the desktop's)."},
         {"version", "", "Show the version."}},
        "The viewer of Hexapose's logs, and of any CSV file.",
        "--export ends with 0 when all rows are good, 1 when some were left out or cells are missing for a\n"
        "cause, 2 when nothing can be read."};
    usage.platformHelp.clear();
    usage.furtherOperands = QStringLiteral("[LOG.csv ...]");
    return usage;
}

namespace {

QString languageOf(const Arguments& arguments) {
    const QString code = languageFromText(QString::fromStdString(arguments.text("language", "")));
    std::vector<std::string> known;
    for (const Language& language : languages())
        known.push_back(language.code.toStdString());
    if (code.isEmpty())
        arguments.choice("language", known, ""); // names those that there are
    return code;
}

std::vector<std::string> wordsOf(const Arguments& arguments, const char* option) {
    std::vector<std::string> words;
    for (const QString& word :
         QString::fromStdString(arguments.text(option, "")).split(QLatin1Char(','), Qt::SkipEmptyParts))
        words.push_back(word.trimmed().toStdString());
    return words;
}

} // namespace

ViewerOptions parseViewerOptions(const QStringList& words) {
    const Arguments arguments(viewerUsage(), words);
    ViewerOptions options;
    options.version = arguments.has("version");
    if (options.version)
        return options;
    for (int i = 0; i < arguments.operandCount(); ++i)
        options.logs.emplace_back(arguments.operand(i));
    options.exportFile = arguments.text("export", "");
    if (arguments.has("from"))
        options.from = arguments.number("from", 0.0);
    if (arguments.has("to"))
        options.to = arguments.number("to", 0.0);
    if (options.from && options.to && !(*options.from < *options.to))
        throw InputError("--to", "is not after --from");
    options.charts = wordsOf(arguments, "charts");
    options.layout = arguments.text("layout", "");
    options.language = languageOf(arguments);
    options.theme = themeFromWord(arguments.choice("theme", {"light", "dark"}, ""));
    if (options.exportFile.empty())
        return options;
    if (!isExportKind(options.exportFile))
        throw InputError("--export", options.exportFile.string() + " ends in none of .png, .svg, .pdf, .csv");
    if (options.logs.size() != 1)
        throw InputError("--export", options.logs.empty() ? "needs a log" : "takes one log");
    return options;
}

} // namespace hexapose
