// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/run_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hexapose::apptest {

bool wasTooBusy(const Outcome& outcome) {
    return outcome.status == 1 && (outcome.err.find("stopped-on-stale-data") != std::string::npos ||
                                   outcome.err.find("stopped-by-controller S") != std::string::npos);
}

Ran runWell(const ForeignController::Traits& traits, const ForeignController::Plan& plan,
            const std::vector<Six>& poses, const std::vector<std::string>& more) {
    Ran ran;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        ran.bench = std::make_unique<Bench>(traits, plan, poses);
        ran.outcome = ran.bench->run(more);
        if (ran.outcome.status == 0 || !(wasTooBusy(ran.outcome) || ran.bench->controller.starved()))
            break;
    }
    return ran;
}

void runOnVirtual(const std::function<Outcome(const Scratch&)>& run,
                  const std::function<void(const Outcome&, const Scratch&)>& expect) {
    for (int attempt = 1;; ++attempt) {
        const Scratch scratch;
        const Outcome outcome = run(scratch);
        if (wasTooBusy(outcome) && attempt < kAttempts)
            continue;
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return expect(outcome, scratch);
    }
}

void expectReached(const std::string& errorsCsv, const std::vector<Six>& targets, double withinMm) {
    const Table errors(errorsCsv);
    ASSERT_THAT(errors.rows, testing::SizeIs(targets.size()));
    for (std::size_t row = 0; row < targets.size(); ++row) {
        EXPECT_EQ(errors.field(row, "status"), "converged");
        for (std::size_t k = 0; k < 6; ++k)
            EXPECT_NEAR(errors.number(row, poseColumns()[k]), targets[row][k], withinMm) << poseColumns()[k];
    }
}

std::vector<std::string> typesOf(const std::vector<std::string>& payloads) {
    std::vector<std::string> types;
    for (const std::string& payload : payloads) {
        const std::string type = splitFields(payload).front();
        if (types.empty() || types.back() != type)
            types.push_back(type);
    }
    return types;
}

void expectReport(const std::string& directory) {
    EXPECT_THAT(readText(directory + "/report.pdf"), testing::StartsWith("%PDF-"));
    EXPECT_THAT(readText(directory + "/errors.png"), testing::StartsWith("\x89PNG"));
    EXPECT_THAT(readText(directory + "/errors.svg"), testing::HasSubstr("<svg"));
}

ForeignController::Traits asTheyAre(ForeignController::Traits traits) {
    traits.bootState = 'D';
    return traits;
}

} // namespace hexapose::apptest
