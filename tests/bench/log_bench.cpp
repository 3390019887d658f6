// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// A large log: how long it takes to read, beside the floors that no reader gets under and a rival where one
// is installed, all in one run with the file in the page cache; its memory; what a redraw asks of the table.
// hexapose-log-bench [ROWS [FILE]]: FILE is made where it is not there.

#include "core/table/reduction.h"
#include "core/table/statistics.h"
#include "core/table/table_loader.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

using namespace hexapose;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kCurvesPerChart = 6, kCharts = 6, kChartPixels = 1100;

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A session log of 42 columns at 1 kHz, about 500 bytes a row.
void writeLog(const fs::path& file, long rows) {
    std::ofstream out(file, std::ios::binary);
    out << "time_s,time_iso,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm,l1_set_mm,l2_set_mm,l3_set_mm,l4_set_mm,l5_"
           "set_mm,l6_set_"
           "mm,x_target_mm,y_target_mm,z_target_mm,alpha_target_deg,beta_target_deg,gamma_target_deg,x_mm,y_"
           "mm,z_mm,alpha_"
           "deg,beta_deg,gamma_deg,status,iterations,residual_mm,state,age_ms,dropped,x_path_mm,y_path_mm,z_"
           "path_mm,alpha_"
           "path_deg,beta_path_deg,gamma_path_deg,mode,speed_percent,q,event\n";
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> noise(-1e-3, 1e-3);
    std::string text;
    std::array<char, 64> number{};
    const auto put = [&](double value, int decimals) {
        text.append(number.data(), static_cast<std::size_t>(
                                       std::snprintf(number.data(), number.size(), "%.*f", decimals, value)));
        text += ',';
    };
    for (long i = 0; i < rows; ++i) {
        const double time = 1e-3 * static_cast<double>(i);
        put(time, 6);
        std::array<char, 96> stamp{};
        const long s = i / 1000;
        std::snprintf(stamp.data(), stamp.size(), "2026-11-%02ldT%02ld:%02ld:%02ld.%03ldZ,", 1 + s / 86400,
                      s / 3600 % 24, s / 60 % 60, s % 60, i % 1000);
        text += stamp.data();
        for (int k = 0; k < 24; ++k)
            put(300.0 + 40.0 * std::sin(0.1 * time + k) + noise(random), 9);
        text += "converged,3,";
        put(1e-7 * (1.0 + noise(random)), 12);
        text += "moving,1.2,0,";
        for (int k = 0; k < 6; ++k)
            put(10.0 * std::sin(0.1 * time + k), 9);
        text += "workspace,100,";
        put(0.98 + noise(random), 4);
        text += i % 50000 == 7 ? "motion-begun joint\n" : "\n";
        if (text.size() > (1U << 22) || i + 1 == rows) {
            out << text;
            text.clear();
        }
    }
}

/// Every field through from_chars and nothing kept, on so many threads: the floor of a reader.
double bareParse(const fs::path& file, int threads) {
    const auto begin = Clock::now();
    const auto size = static_cast<off_t>(fs::file_size(file));
    std::vector<std::jthread> all;
    std::vector<double> sums(static_cast<std::size_t>(threads));
    for (int thread = 0; thread < threads; ++thread)
        all.emplace_back([&, thread] {
            const int descriptor = ::open(file.c_str(), O_RDONLY);
            std::vector<char> block(std::size_t{1} << 20);
            double sum = 0.0;
            for (off_t at = thread * static_cast<off_t>(block.size()); at < size;
                 at += threads * static_cast<off_t>(block.size())) {
                const ssize_t count = ::pread(descriptor, block.data(), block.size(), at);
                const char* const end = block.data() + std::max<ssize_t>(count, 0);
                for (const char* field = block.data(); field < end;) {
                    double value = 0.0;
                    const auto [stop, error] = std::from_chars(field, end, value);
                    sum += error == std::errc() ? value : 0.0;
                    for (field = stop; field < end && *field != ',' && *field != '\n'; ++field) {
                    }
                    ++field;
                }
            }
            ::close(descriptor);
            sums[static_cast<std::size_t>(thread)] = sum;
        });
    all.clear();
    volatile double sink = sums.front();
    static_cast<void>(sink);
    return secondsSince(begin);
}

double shell(const std::string& command) {
    const auto begin = Clock::now();
    return std::system(command.c_str()) == 0 ? secondsSince(begin) : std::nan("");
}

/// VmRSS without what files share.
double anonymousBytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("RssAnon:"))
            return 1024.0 * std::strtod(line.c_str() + 8, nullptr);
    return std::nan("");
}

void printRow(const char* name, double seconds, double floor, const char* floorName, const char* goal) {
    std::printf("  %-44s %8.2f s", name, seconds);
    if (floor > 0.0)
        std::printf("  %5.2f x %-12s %s", seconds / floor, floorName, goal);
    std::printf("\n");
}

void benchRedraw(const Table& table) {
    std::vector<std::size_t> curves;
    for (std::size_t i = 0; i < table.columns().size(); ++i)
        if (table.columns()[i].isNumber() && curves.size() < kCurvesPerChart * kCharts)
            curves.push_back(i);
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<double> times;
    for (int i = 0; i < 100; ++i) {
        const double width = table.time().end() * std::pow(10.0, -5.0 * part(random));
        const double from = (table.time().end() - width) * part(random);
        const auto begin = Clock::now();
        std::size_t drawn = 0;
        for (int c = 0; c < kCurvesPerChart * kCharts; ++c)
            drawn += reduceToPixels(table.columns()[curves[static_cast<std::size_t>(c) % curves.size()]],
                                    table.time(), {from, from + width, kChartPixels})
                         .size();
        times.push_back(1e3 * secondsSince(begin));
        if (drawn == 0)
            std::puts("  nothing drawn");
    }
    std::sort(times.begin(), times.end());
    std::printf(
        "  redraw, data of %d curves over %d pixels       median %.1f ms, worst %.1f ms (goal 5 ms)\n",
        kCurvesPerChart * kCharts, kChartPixels, times[times.size() / 2], times.back());
}

} // namespace

int main(int argc, char** argv) {
    const long rows = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 1000000;
    const fs::path file =
        argc > 2 ? fs::path(argv[2])
                 : fs::temp_directory_path() / ("hexapose-bench-" + std::to_string(rows) + ".csv");
    if (!fs::exists(file))
        writeLog(file, rows);
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const double lines = shell("wc -l '" + file.string() + "' >/dev/null");
    const double copy = shell("cat '" + file.string() + "' | cat >/dev/null");
    const double parse = bareParse(file, threads);
    std::printf("a log of %ld rows, %.2f GB, in the page cache; %d threads\n", rows,
                1e-9 * static_cast<double>(fs::file_size(file)), threads);
    printRow("wc -l", lines, 0.0, "", "");
    printRow("cat | cat", copy, 0.0, "", "");
    printRow("bare parse of all fields", parse, 0.0, "", "");
    const double before = anonymousBytes();
    const auto begin = Clock::now();
    double firstRows = 0.0;
    std::shared_ptr<const Table> table;
    {
        std::atomic<TableLoader*> self{nullptr};
        std::atomic<double> first{0.0};
        TableLoader loader(file, {{}, 0, [&] {
                                      if (TableLoader* l = self.load();
                                          l != nullptr && first == 0.0 && l->progress().rows > 0)
                                          first = secondsSince(begin);
                                  }});
        self = &loader;
        loader.wait();
        table = loader.table();
        firstRows = first;
    }
    const double load = secondsSince(begin);
    printRow("all columns into a table", load, parse, "bare parse", "(goal 4)");
    printRow("the same", load, copy, "cat | cat", "(goal 4)");
    printRow("first rows usable", firstRows, 0.0, "", "(goal 0.3 s)");
    const double columns =
        8.0 * static_cast<double>(table->rowCount()) * static_cast<double>(table->columns().size());
    std::printf(
        "  memory beyond the start                       %8.2f GB %5.2f x columns as doubles (goal 1.15)\n",
        1e-9 * (anonymousBytes() - before), (anonymousBytes() - before) / columns);
    benchRedraw(*table);
    const auto sumsBegin = Clock::now();
    const Statistics all = statisticsOf(table->columns()[2], 0, table->rowCount());
    std::printf("  statistics of one column, all rows             %.1f ms (count %zu)\n",
                1e3 * secondsSince(sumsBegin), all.count);
    if (std::system("command -v kst2 >/dev/null 2>&1") != 0)
        std::puts("  kst: not installed");
    if (argc <= 2)
        fs::remove(file);
    return 0;
}
