// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_export.h"

#include "core/base/input_error.h"
#include "core/base/units.h"
#include "core/geometry/geometry_file.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "ui/common/language.h"

#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cmath>

namespace hexapose {
namespace {

namespace fs = std::filesystem;

const std::vector<QRgb> kSeriesColours{qRgb(0x00, 0x72, 0xB2), qRgb(0xD5, 0x5E, 0x00),
                                       qRgb(0x00, 0x9E, 0x73)};

/// Samples of the laboratory platform, `scale` times as large, with lengths rounded to a resolution in its
/// proportion; every `failEvery`-th without a solution.
ErrorReport makeReport(int count, double scale = 1.0, int failEvery = 0) {
    PlatformGeometry geometry =
        loadPlatform(std::string(HEXAPOSE_SOURCE_DIR) + "/resources/platforms/laboratory.toml");
    geometry.name = "平台 <A> & a name";
    geometry.p_OP_home_B *= scale;
    for (Leg& leg : geometry.legs) {
        leg.p_OA_B *= scale;
        leg.p_PB_P *= scale;
        leg.minLength *= scale;
        leg.maxLength *= scale;
    }
    const double resolution = 1e-4 * scale;
    std::vector<SettledSample> samples;
    for (const Pose& pose : randomPoses(geometry, count, 0.01 * scale, radiansFromDeg(10.0), 5)) {
        SettledSample sample;
        sample.target = pose;
        sample.meanLengths =
            ((legLengths(geometry, pose) / resolution).array().round() * resolution).matrix();
        sample.measurements = 100;
        samples.push_back(sample);
        if (failEvery > 0 && static_cast<int>(samples.size()) % failEvery == 0)
            samples.back().meanLengths[0] = std::nan("");
    }
    return makeErrorReport(geometry, NewtonRaphson(geometry, {}), samples, resolution);
}

QByteArray readAll(const fs::path& file) {
    QFile in(QFile::decodeName(file.c_str()));
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

int pagesOf(const QByteArray& pdf) {
    return static_cast<int>(
        QString::fromLatin1(pdf).count(QRegularExpression(QStringLiteral("/Type\\s*/Page\\b(?!s)"))));
}

int pixelsOf(const QImage& image, QRgb colour, const QRect& area) {
    int count = 0;
    for (int y = area.top(); y <= area.bottom(); ++y)
        for (int x = area.left(); x <= area.right(); ++x)
            count += image.pixel(x, y) == colour ? 1 : 0;
    return count;
}

class ReportExport : public testing::Test {
protected:
    QTemporaryDir scratch;
    const fs::path directory = fs::path(scratch.path().toStdString()) / "new" / "report";
};

TEST_F(ReportExport, WritesFourFilesThatHoldTheReport) {
    const ErrorReport report = makeReport(10);
    const auto files = exportErrorReport(report, directory);
    ASSERT_EQ(files, (std::vector<fs::path>{directory / "report.pdf", directory / "errors.csv",
                                            directory / "errors.png", directory / "errors.svg"}));
    EXPECT_EQ(std::distance(fs::directory_iterator(directory), fs::directory_iterator()), 4)
        << "nothing else is left";
    EXPECT_EQ(readAll(files[1]).toStdString(), formatErrorCsv(report));

    const QByteArray pdf = readAll(files[0]);
    EXPECT_TRUE(pdf.startsWith("%PDF-"));
    EXPECT_EQ(pagesOf(pdf), 3) << "figure, five samples, five samples";
    EXPECT_TRUE(pdf.contains("MediaBox [0 0 595"));

    const QImage png(QFile::decodeName(files[2].c_str()));
    ASSERT_GE(png.width(), 1600);
    EXPECT_EQ(png.pixel(0, 0), qRgb(255, 255, 255));
    const QRect upper(0, png.height() / 8, png.width(), png.height() * 3 / 8);
    for (const QRect& half : {upper, upper.translated(0, png.height() / 2)})
        for (const QRgb colour : kSeriesColours)
            EXPECT_GT(pixelsOf(png, colour, half), 1000) << "each coordinate has its line in its panel";

    const QByteArray svg = readAll(files[3]);
    EXPECT_TRUE(QSvgRenderer(svg).isValid());
    for (const char* text : {"Angle error (rad)", "Displacement error (m)", "Sample", "×10⁻³", "×10⁻⁴", "α",
                             "β", "γ", "largest predicted for 0.1 mm resolution", ">10<"})
        EXPECT_TRUE(svg.contains(text)) << text;
    EXPECT_FALSE(svg.contains("no solution"));
    EXPECT_TRUE(svg.contains(">0.5<")) << "numbers with a point, whatever the desktop's language";
}

TEST_F(ReportExport, SpeaksTheLanguageOfTheWindowButNotInItsNumbersAndColumns) {
    const ErrorReport report = makeReport(6, 1.0, 3);
    LanguageSwitch language;
    ASSERT_TRUE(language.choose(QStringLiteral("zh_CN")));
    const auto files = exportErrorReport(report, directory);
    const QByteArray svg = readAll(files[3]);
    for (const char* text : {"角度误差", "位移误差", "样本", "无可用解", "运动学正解误差报告", ">0.5<"})
        EXPECT_TRUE(svg.contains(text)) << text;
    for (const char* text : {"error", "Sample", "largest", "no solution"})
        EXPECT_FALSE(svg.contains(text)) << text;
    EXPECT_EQ(pagesOf(readAll(files[0])), 3);
    EXPECT_EQ(readAll(files[1]).toStdString(), formatErrorCsv(report));
}

TEST_F(ReportExport, WorksForEverySizeOfRunAndMachine) {
    struct Case {
        int count;
        double scale;
        int failEvery;
        int pages;
        const char* text;
    };
    for (const Case& c :
         {Case{0, 1.0, 0, 1, "No samples"}, Case{1, 1.0, 0, 2, "Sample"},
          Case{200, 1.0, 3, 41, "no solution"}, Case{6, 1.0, 1, 3, "No sample has a usable solution"},
          Case{10, 1e-4, 0, 3, "×10⁻⁸"}, Case{10, 1e7, 0, 3, "Sample"}}) {
        const ErrorReport report = makeReport(c.count, c.scale, c.failEvery);
        const auto files = exportErrorReport(report, directory);
        EXPECT_EQ(pagesOf(readAll(files[0])), c.pages) << c.count << " samples, scale " << c.scale;
        EXPECT_TRUE(readAll(files[3]).contains(c.text)) << c.text;
        const QImage png(QFile::decodeName(files[2].c_str()));
        const bool anyUsable = report.failed < static_cast<int>(report.rows.size());
        const QRect plots(0, png.height() / 8, png.width(), png.height() * 3 / 8);
        EXPECT_EQ(pixelsOf(png, kSeriesColours[2], plots) > 0, anyUsable);
    }
}

TEST_F(ReportExport, SaysWhatCannotBeWritten) {
    const ErrorReport report = makeReport(2);
    fs::create_directories(directory / "errors.csv");
    try {
        exportErrorReport(report, directory);
        FAIL() << "a directory in the way of a file";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("errors.csv: cannot be written"), std::string::npos)
            << error.what();
    }
    fs::remove(directory / "errors.csv");
    exportErrorReport(report, directory);
    EXPECT_NO_THROW(exportErrorReport(report, directory)) << "a report of before is replaced";
    EXPECT_THROW(exportErrorReport(report, directory / "errors.csv"), InputError);
}

TEST(ErrorPanels, StayInsideTheirArea) {
    const ErrorReport report = makeReport(10, 1.0, 4);
    for (const QSize size : {QSize(360, 270), QSize(1200, 500), QSize(500, 1200)}) {
        QImage image(size, QImage::Format_RGB32);
        image.fill(Qt::magenta);
        const QRect area = image.rect().adjusted(20, 20, -20, -20);
        QPainter painter(&image);
        paintErrorPanels(painter, area, report);
        painter.end();
        const QRgb outside = qRgb(255, 0, 255);
        EXPECT_EQ(pixelsOf(image, outside, image.rect()),
                  size.width() * size.height() - area.width() * area.height());
        EXPECT_GT(pixelsOf(image, kSeriesColours[0], area), 0);
    }
}

} // namespace
} // namespace hexapose
