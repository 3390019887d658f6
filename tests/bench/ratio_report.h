// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace hexapose::bench {

/// Keeps the shortest of the repetitions of each benchmark, for a shared machine only ever adds time, and
/// prints them beside the yardsticks at the end.
class RatioReport final : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& context) override;
    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

private:
    struct Best {
        double nanoseconds; ///< one pose, or one run where there are no poses
        double iterations;
        double flops; ///< of one pose; 0: not counted
    };
    const Best* find(const std::string& name) const;
    void printRow(const std::string& name, const Best& best) const;

    std::vector<std::string> m_order;
    std::map<std::string, Best> m_best;
};

} // namespace hexapose::bench
