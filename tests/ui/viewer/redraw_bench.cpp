// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long six charts of six curves take to be drawn again while the view moves: hexapose-viewer-bench
// LOG.csv

#include "core/base/input_error.h"
#include "core/table/table_loader.h"
#include "ui/viewer/chart_sheet.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

namespace {

using namespace hexapose;

constexpr int kCharts = 6;
constexpr std::size_t kCurves = 6;
constexpr int kViews = 200;
constexpr QSize kSize(1400, 900);

ChartLayout layoutOf(const Table& table) {
    std::vector<CurveSpec> numbers;
    for (const Column& column : table.columns())
        if (column.isNumber())
            numbers.push_back({QString::fromStdString(column.info().name), {}});
    ChartLayout layout;
    for (std::size_t i = 0; i < kCharts; ++i) {
        ChartSpec chart;
        for (std::size_t c = 0; c < kCurves && !numbers.empty(); ++c)
            chart.curves.push_back(numbers[(i * kCurves + c) % numbers.size()]);
        layout.charts.push_back(chart);
    }
    return layout;
}

void measure(const char* file) {
    QElapsedTimer clock;
    clock.start();
    const auto table = loadTable(file);
    std::printf("rows: %zu, read in %.2f s\n", table->rowCount(),
                1e-3 * static_cast<double>(clock.elapsed()));
    ChartSheet sheet;
    sheet.resize(kSize);
    sheet.setTable(table);
    sheet.setChartLayout(layoutOf(*table));
    QImage image(kSize, QImage::Format_ARGB32_Premultiplied);
    sheet.show();
    sheet.render(&image);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(table->time().begin(), table->time().end());
    std::uniform_real_distribution<double> logLength(-4.0, 0.0);
    std::vector<double> times;
    for (int i = 0; i < kViews; ++i) {
        const double length =
            std::pow(10.0, logLength(random)) * (table->time().end() - table->time().begin());
        const double begin = place(random) - 0.5 * length;
        const std::clock_t before = std::clock();
        sheet.showTime({begin, begin + length});
        sheet.render(&image);
        times.push_back(1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    }
    std::sort(times.begin(), times.end());
    std::printf(
        "processor time of a redraw of %d charts of %zu curves: median %.1f ms, p95 %.1f ms, worst %.1f ms\n",
        kCharts, kCurves, times[kViews / 2], times[kViews * 95 / 100], times.back());
}

} // namespace

int main(int argc, char* argv[]) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    if (argc != 2) {
        std::fprintf(stderr, "usage: hexapose-viewer-bench LOG.csv\n");
        return 2;
    }
    try {
        measure(argv[1]);
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
