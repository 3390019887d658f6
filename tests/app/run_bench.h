// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/foreign_controller.h"
#include "tests/app/process.h"
#include "tests/app/run_log.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hexapose::apptest {

inline const Six kFigure7{12, -4, 40, 0, 0, 5};

/// A controller on a port, targets, and where the log goes.
struct Bench {
    explicit Bench(const ForeignController::Traits& traits = {}, const ForeignController::Plan& plan = {},
                   std::vector<Six> poses = {kFigure7})
        : targets(scratch.file("targets.csv", csv(poseColumns(), poses))),
          controller(scratch.path("port"), traits, plan) {}

    std::vector<std::string> words(const std::string& logName = "log.csv") const {
        return {"run", "--port", scratch.path("port"), "--targets", targets, "--log", scratch.path(logName)};
    }
    /// A word that begins with @ is a path among the scratch files.
    Outcome run(const std::vector<std::string>& more = {}) {
        std::vector<std::string> all = words();
        for (const std::string& word : more)
            all.push_back(word.starts_with('@') ? scratch.path(word.substr(1)) : word);
        return cli(all);
    }
    RunLog log(const std::string& name = "log.csv") const { return RunLog(scratch.path(name)); }

    Scratch scratch;
    std::string targets;
    ForeignController controller;
};

struct Ran {
    std::unique_ptr<Bench> bench;
    Outcome outcome;
};

inline constexpr int kAttempts = 6; ///< on a machine that is too busy to keep the times of a controller

/// A program that does not get to read for 200 ms stops the platform, and one that does not get to write for
/// 250 ms is stopped by the watchdog; both rightly.
bool wasTooBusy(const Outcome& outcome);

/// A run that must go well. It is repeated when the machine was too busy for the program, or even for the
/// controller to keep its times.
Ran runWell(const ForeignController::Traits& traits, const ForeignController::Plan& plan,
            const std::vector<Six>& poses, const std::vector<std::string>& more = {});

/// A run on a platform of ours that must go well, each time in a folder of its own: repeated when the machine
/// was too busy to keep the times of a controller.
void runOnVirtual(const std::function<Outcome(const Scratch&)>& run,
                  const std::function<void(const Outcome&, const Scratch&)>& expect);

/// errors.csv of a run that went well: reached within what the resolution explains.
void expectReached(const std::string& errorsCsv, const std::vector<Six>& targets, double withinMm);

/// The type of each payload, repeats in a row once.
std::vector<std::string> typesOf(const std::vector<std::string>& payloads);
void expectReport(const std::string& directory);
/// A controller that is referenced already.
ForeignController::Traits asTheyAre(ForeignController::Traits traits);

} // namespace hexapose::apptest
