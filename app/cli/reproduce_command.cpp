// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/cli/reproduce/exhibit_files.h"
#include "app/cli/reproduce/exhibit_text.h"
#include "app/cli/reproduce/exhibits.h"
#include "app/cli/reproduce/reproduction_pdf.h"
#include "app/cli/solver_choice.h"
#include "app/common/arguments.h"
#include "app/common/directories.h"
#include "core/base/input_error.h"
#include "ui/plot/picture_files.h"

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace hexapose {

namespace {

namespace fs = std::filesystem;
using reproduce::Exhibit;
using reproduce::ExhibitMaker;

/// Of the platform that the paper describes: its Table 1, with the origin at z = 272.9 mm.
constexpr const char* kPublishedPlatform = "771565c1545db4a0";

std::vector<ExhibitMaker> chosenMakers(const std::string& what) {
    std::string known;
    for (const ExhibitMaker& maker : reproduce::exhibitMakers()) {
        if (what == maker.name)
            return {maker};
        known += std::string(maker.name) + ", ";
    }
    if (what == "all")
        return reproduce::exhibitMakers();
    throw InputError("reproduce", "unknown table or figure '" + what + "' (known: " + known + "all)");
}

PlatformGeometry publishedPlatform(const Arguments& arguments) {
    PlatformGeometry platform = arguments.platform();
    if (platform.fingerprint() != kPublishedPlatform)
        throw InputError("--platform", "\"" + platform.name +
                                           "\" is not the laboratory platform, to which the published values "
                                           "belong");
    return platform;
}

std::vector<Exhibit> makeExhibits(const std::vector<ExhibitMaker>& makers, const PlatformGeometry& platform) {
    reproduce::Experiment experiment(platform);
    std::vector<Exhibit> exhibits;
    exhibits.reserve(makers.size());
    const auto count = static_cast<double>(makers.size());
    for (const ExhibitMaker& maker : makers)
        exhibits.push_back(maker.make(experiment, [&](double part) {
            showProgress("reproducing", (static_cast<double>(exhibits.size()) + part) / count);
        }));
    showProgress("reproducing", 1.0);
    return exhibits;
}

/// Everything is on disk before the first line is printed.
void showExhibits(const std::vector<Exhibit>& exhibits) {
    std::string separator;
    for (const Exhibit& exhibit : exhibits) {
        const std::string text = separator + reproduce::exhibitText(exhibit) + reproduce::timesText(exhibit);
        std::fwrite(text.data(), 1, text.size(), stdout);
        separator = "\n" + std::string(reproduce::kTextColumns, '=') + "\n\n";
    }
}

bool reportDeviations(const std::vector<Exhibit>& exhibits) {
    bool any = false;
    for (const Exhibit& exhibit : exhibits)
        for (const reproduce::Check& check : exhibit.checks) {
            if (check.holds())
                continue;
            any = true;
            std::fprintf(stderr, "hexapose-cli: %s: %s\n", exhibit.name.c_str(), check.text().c_str());
        }
    return any;
}

} // namespace

Usage reproduceUsage() {
    return {"hexapose-cli reproduce",
            {QStringLiteral("table2|table3|table4|table5|figure3|figure5|figure13|figure15|figure16|all")},
            {{"out", "DIR", "Directory of the texts, CSV, pictures and (all) the PDF."}}};
}

int reproduceCommand(const Arguments& arguments) {
    const std::string what = arguments.operand(0);
    const std::vector<ExhibitMaker> makers = chosenMakers(what);
    const fs::path directory = arguments.requiredText("out");
    const PlatformGeometry platform = publishedPlatform(arguments);
    makeDirectory(directory);
    const std::vector<Exhibit> exhibits = makeExhibits(makers, platform);
    for (const Exhibit& exhibit : exhibits)
        reproduce::writeExhibit(exhibit, directory);
    if (what == "all")
        writeWholeFile(directory / "reproduction.pdf", reproduce::reproductionPdf(exhibits));
    showExhibits(exhibits);
    return reportDeviations(exhibits) ? kExitSomeFailed : kExitDone;
}

} // namespace hexapose
