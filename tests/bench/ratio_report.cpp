// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "ratio_report.h"

#include <algorithm>
#include <cstdio>

namespace hexapose::bench {

namespace {

/// "cold, set 2 / ..." is to be read beside "cold, set 2 / yardstick".
std::string jobOf(const std::string& name) {
    return name.substr(0, name.find(" / "));
}

double counterOf(const benchmark::BenchmarkReporter::Run& run, const char* name) {
    const auto found = run.counters.find(name);
    return found == run.counters.end() ? 0.0 : static_cast<double>(found->second);
}

} // namespace

bool RatioReport::ReportContext(const Context&) {
    return true;
}

void RatioReport::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration || run.error_occurred)
            continue;
        const std::string name = run.run_name.function_name;
        const double poses = std::max(1.0, counterOf(run, "poses"));
        const double seconds = run.real_accumulated_time / static_cast<double>(run.iterations) / poses;
        const Best now{1e9 * seconds, counterOf(run, "iterations"), counterOf(run, "flops")};
        const auto [place, fresh] = m_best.emplace(name, now);
        if (fresh)
            m_order.push_back(name);
        else if (now.nanoseconds < place->second.nanoseconds)
            place->second = now;
    }
}

const RatioReport::Best* RatioReport::find(const std::string& name) const {
    const auto found = m_best.find(name);
    return found == m_best.end() ? nullptr : &found->second;
}

void RatioReport::printRow(const std::string& name, const Best& best) const {
    char iterations[32] = "", ratios[64] = "";
    if (best.iterations > 0.0)
        std::snprintf(iterations, sizeof iterations, "%.2f", best.iterations);
    const Best* plain = find(jobOf(name) + " / yardstick");
    const Best* native = find(jobOf(name) + " / yardstick, this processor");
    if (plain != nullptr && native != nullptr)
        std::snprintf(ratios, sizeof ratios, "%8.1fx %10.1fx", plain->nanoseconds / best.nanoseconds,
                      native->nanoseconds / best.nanoseconds);
    const bool slow = best.nanoseconds > 1e5;
    char work[32] = "";
    if (best.flops > 0.0)
        std::snprintf(work, sizeof work, "  %.1f GFLOP/s", best.flops / best.nanoseconds);
    std::printf("%-46s %10.*f %s %11s %s%s\n", name.c_str(), slow ? 1 : 0,
                slow ? best.nanoseconds * 1e-6 : best.nanoseconds, slow ? "ms" : "ns", iterations, ratios,
                work);
}

void RatioReport::Finalize() {
    std::printf(
        "\nThe shortest of the repetitions, on one thread. The last columns: how many times faster than the\n"
        "yardstick (a plain Newton with Eigen), compiled as the programs are, and for this processor.\n\n");
    std::printf("%-46s %13s %11s %9s %11s\n", "", "time a pose", "iterations", "yardstick", "its native");
    std::sort(m_order.begin(), m_order.end());
    for (const std::string& name : m_order)
        printRow(name, *find(name));
    std::fflush(stdout);
}

} // namespace hexapose::bench
