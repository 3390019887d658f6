// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is shown and written of the reproduction, at a small size.
#include "app/cli/reproduce/exhibit_files.h"
#include "app/cli/reproduce/exhibit_text.h"
#include "app/cli/reproduce/exhibits.h"
#include "app/cli/reproduce/reproduction_pdf.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text_file.h"
#include "core/geometry/geometry_file.h"

#include <QImage>
#include <QSvgRenderer>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace hexapose::reproduce {
namespace {

namespace fs = std::filesystem;

constexpr ExperimentSize kForFiles{1000, 500};

std::vector<Exhibit> makeAll() {
    Experiment experiment(
        loadPlatform(std::string(HEXAPOSE_SOURCE_DIR) + "/resources/platforms/laboratory.toml"), kForFiles);
    std::vector<Exhibit> exhibits;
    for (const ExhibitMaker& maker : exhibitMakers()) {
        double part = 0.0;
        exhibits.push_back(maker.make(experiment, [&](double now) {
            EXPECT_GE(now, part);
            EXPECT_LT(now, 1.0);
            part = now;
        }));
        EXPECT_EQ(exhibits.back().name, maker.name);
    }
    return exhibits;
}

const std::vector<Exhibit>& all() {
    static const std::vector<Exhibit> exhibits = makeAll();
    return exhibits;
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);)
        parts.push_back(part);
    if (!text.empty() && text.back() == at && at != '\n')
        parts.emplace_back();
    return parts;
}

TEST(ReproductionText, FitsTheScreenAndNamesTheMisprints) {
    for (const Exhibit& exhibit : all()) {
        SCOPED_TRACE(exhibit.name);
        const std::string text = exhibitText(exhibit) + timesText(exhibit);
        for (const std::string& line : split(text, '\n')) {
            EXPECT_LE(line.size(), kTextColumns) << line;
            EXPECT_FALSE(line.ends_with(' ')) << line;
        }
        EXPECT_TRUE(text.ends_with("\n") && !text.ends_with("\n\n"));
        EXPECT_EQ(text.find("nan"), std::string::npos);
    }
    const auto says = [](const char* name, const char* words) {
        const auto found =
            std::find_if(all().begin(), all().end(), [&](const Exhibit& e) { return e.name == name; });
        std::string flat = exhibitText(*found);
        std::replace(flat.begin(), flat.end(), '\n', ' ');
        return flat.find(words) != std::string::npos;
    };
    EXPECT_TRUE(says("table3", "Table 2 is the reproducible one"));
    EXPECT_TRUE(says("figure13", "the error of the open form falls as 1/n"));
    EXPECT_TRUE(says("figure15", "another assembly mode"));
    EXPECT_TRUE(says("figure16", "is no such average"));
    EXPECT_TRUE(says("table5", "0.0896, is a misprint of 0.0869"));
    for (const char* name : {"table2", "table3", "table4", "figure5"})
        EXPECT_TRUE(says(name, "error is tested before the update")) << name;
}

TEST(ReproductionText, ListsTimesApart) {
    for (const Exhibit& exhibit : all()) {
        const bool timed = exhibit.name == "table2" || exhibit.name == "table3" ||
                           exhibit.name == "figure13" || exhibit.name == "figure15";
        EXPECT_EQ(!timesText(exhibit).empty(), timed);
        EXPECT_EQ(!exhibit.timesCsv.empty(), timed);
        EXPECT_EQ(exhibitText(exhibit).find("MATLAB"), std::string::npos);
    }
}

TEST(ReproductionCsv, ReadsBack) {
    const std::vector<std::size_t> rows{36, 42, 16, 6, 201, 16, 54, 94, 1001};
    for (std::size_t i = 0; i < all().size(); ++i) {
        const Exhibit& exhibit = all()[i];
        SCOPED_TRACE(exhibit.name);
        const std::vector<std::string> lines = split(exhibit.csv, '\n');
        ASSERT_EQ(lines.size(), rows[i] + 1);
        const std::vector<std::string> header = split(lines.front(), ',');
        for (const std::string& line : lines)
            EXPECT_EQ(split(line, ',').size(), header.size()) << line;
        for (std::size_t column = 0; column < header.size(); ++column) {
            if (header[column].find("published") == std::string::npos)
                continue;
            for (std::size_t row = 1; row < lines.size(); ++row)
                EXPECT_TRUE(parseNumber(split(lines[row], ',')[column])) << lines[row];
        }
    }
}

TEST(ReproductionFiles, AreTheSameForTheSameNumbers) {
    const std::vector<Exhibit> again = makeAll();
    const QTemporaryDir directory;
    const fs::path first = directory.filePath("first").toStdString();
    const fs::path second = directory.filePath("second").toStdString();
    fs::create_directories(first);
    fs::create_directories(second);
    for (std::size_t i = 0; i < again.size(); ++i) {
        writeExhibit(all()[i], first);
        writeExhibit(again[i], second);
        const std::string name = again[i].name;
        for (const char* ending : {".txt", ".csv", ".png", ".svg"})
            EXPECT_EQ(readTextFile(first / (name + ending)), readTextFile(second / (name + ending)))
                << name << ending;
        const QImage image(QString::fromStdString((first / (name + ".png")).string()));
        EXPECT_EQ(image.size(), (again[i].picture.size() * 2.0).toSize());
        QSvgRenderer vector(QString::fromStdString((first / (name + ".svg")).string()));
        EXPECT_TRUE(vector.isValid());
        EXPECT_EQ(fs::exists(first / (name + "-times.csv")), !again[i].timesCsv.empty());
        EXPECT_EQ(fs::exists(first / (name + "-times.svg")), again[i].timesPicture.has_value());
        for (const Check& check : again[i].checks)
            if (name.size() > 7) { // of the second paper, which needs no size of its own
                EXPECT_TRUE(check.holds()) << name << ": " << check.text();
            }
    }
    EXPECT_THROW(writeExhibit(again.front(), directory.filePath("missing").toStdString()), InputError);
}

TEST(ReproductionPdf, HasAllPages) {
    const QByteArray pdf = reproductionPdf(all());
    EXPECT_TRUE(pdf.startsWith("%PDF-"));
    EXPECT_GE(pdf.count("/Type /Page\n"), static_cast<qsizetype>(1 + all().size()));
}

} // namespace
} // namespace hexapose::reproduce
