// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/cli/number_rows.h"
#include "app/cli/solver_choice.h"
#include "app/common/arguments.h"
#include "app/common/platform_check.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/unit_text.h"
#include "core/base/units.h"
#include "core/kinematics/pose_accuracy.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

namespace hexapose {

namespace {

constexpr const char* kColumns = "x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg,status,iterations,residual_mm";
constexpr const char* kDetails = ",position_bound_mm,rotation_bound_deg,condition,smallest_singular_value,x_"
                                 "sigma_mm,y_sigma_mm,z_sigma_mm,"
                                 "alpha_sigma_deg,beta_sigma_deg,gamma_sigma_deg";
constexpr const char* kFallbackDetails = ",fallback,fallback_step";
constexpr int kDetailCount = 10;

void appendRow(std::string& out, const ForwardResult& result) {
    if (result.hasPose()) {
        for (int k = 0; k < 3; ++k)
            out += mmText(result.pose.offset[k]) + ",";
        for (const double angle :
             {result.pose.angles.alpha, result.pose.angles.beta, result.pose.angles.gamma})
            out += degText(angle) + ",";
    } else {
        out += ",,,,,,";
    }
    out += std::string(toWord(result.status)) + "," + std::to_string(result.iterations) + ",";
    if (result.hasPose())
        out += mmText(result.residual);
}

/// How far the exact pose can be, and what the resolution of the lengths does. Empty where nothing can be
/// said.
void appendDetails(std::string& out, const PlatformModel& platform, const ForwardResult& result,
                   double resolution) {
    if (!result.hasPose()) {
        out.append(kDetailCount, ',');
        return;
    }
    const auto append = [&out](double value, std::string text) {
        out += "," + (std::isfinite(value) ? std::move(text) : std::string());
    };
    const PoseAccuracy accuracy = poseAccuracy(platform, result.pose, result.residual);
    append(accuracy.offsetBound, mmText(accuracy.offsetBound));
    append(accuracy.angleBound, degText(accuracy.angleBound));
    append(accuracy.condition, formatNumber(accuracy.condition));
    append(accuracy.smallestSingularValue, formatNumber(accuracy.smallestSingularValue));
    const PoseVector sigma = roundingEffect(platform.geometry(), result.pose, resolution).sigma;
    for (int k = 0; k < 6; ++k)
        append(sigma[k], k < 3 ? mmText(sigma[k]) : degText(sigma[k]));
}

/// Of --start: home also before the first of the previous ones, or a known pose, "x,y,z,alpha,beta,gamma".
Pose startPose(const std::string& text) {
    if (text == "home" || text == "previous")
        return {};
    const QStringList words = QString::fromStdString(text).split(QLatin1Char(','));
    PoseVector pose;
    for (int k = 0; k < 6; ++k) {
        const auto number =
            words.size() == 6 ? parseNumber(words[k].trimmed().toStdString()) : std::optional<double>();
        if (!number || !std::isfinite(*number))
            throw InputError("--start", "'" + text +
                                            "' is neither home nor previous nor a pose (six numbers, mm and "
                                            "deg, with commas)");
        pose[k] = k < 3 ? metresFromMm(*number) : radiansFromDeg(*number);
    }
    return Pose::fromVector(pose);
}

/// Whether MPR-NR was not sure of its branch, so that the path from the start was followed, what came of it,
/// and at which step it ended. "followed": the pose is the end of the path. "confirmed": the path led to the
/// solver's own pose. "stopped": before a singular pose, and the row is the solver's. Empty: it was sure.
void appendFallback(std::string& out, const PathFallback::Answer& answer) {
    if (!answer.path) {
        out += ",,";
        return;
    }
    out += answer.fromPath ? ",followed," : answer.result.isUsable() ? ",confirmed," : ",stopped,";
    out += std::to_string(answer.path->step);
}

} // namespace

Usage forwardUsage() {
    return {"hexapose-cli forward",
            {QStringLiteral("LENGTHS.csv")},
            {{"method", "M", "newton, newton-as-published, mpr2, mpr3, mpr2-nr, mpr3-nr (default) or fsi.",
              methodWords()},
             {"model", "FILE", "Regression model (default: the platform's own, trained on first use)."},
             {"start", "home|previous|POSE",
              "Where the iteration or the path begins (default: home); POSE: six numbers, mm and deg."},
             {"tolerance-mm", "T", "Largest residual of a solution, mm."},
             {"max-iterations", "N", "Most Newton iterations (default: 50)."},
             {"steps", "N", "Steps of fsi (default: 1000)."},
             {"form", "open|closed|corrected", "Form of a step of fsi (default: corrected)."},
             {"details", "", "Also bounds of the error, condition, standard deviations, and the fallback."},
             {"resolution-mm", "R", "Resolution of the lengths, for --details (default: 0.1)."}}};
}

int forwardCommand(const Arguments& arguments) {
    const std::string start = arguments.text("start", "home");
    Pose from = startPose(start);
    const bool details = arguments.has("details");
    const double resolution = metresFromMm(arguments.positive("resolution-mm", 0.1));
    const PlatformGeometry platform = arguments.platform();
    warnUnlessMovable(platform, arguments.text("platform", "laboratory"));
    const CsvTable table = readCsv(arguments.operand(0));
    const NumberRows rows(table, kLengthColumns);
    const ChosenSolver chosen = chooseSolver(arguments, platform, SingularHome::Allowed);
    const PathFallback* fallback = chosen.fallback();
    const PlatformModel model(platform);

    bool allOk = true;
    std::string out = kColumns;
    out += details ? std::string(kDetails) + kFallbackDetails + "\n" : "\n";
    for (const CsvTable::Row& row : everyRow(table)) {
        PathFallback::Answer answer; // invalid-input
        if (const auto lengths = rows.read(row)) {
            const LegLengths metres = lengths->unaryExpr(&metresFromMm);
            if (fallback != nullptr)
                answer = fallback->answer(metres, from);
            else
                answer.result = chosen.solver->solve(metres, from);
        }
        const ForwardResult& result = answer.result;
        if (start == "previous" && result.isUsable())
            from = result.pose;
        allOk = allOk && result.isUsable();
        appendRow(out, result);
        if (details) {
            appendDetails(out, model, result, resolution);
            appendFallback(out, answer);
        }
        out += "\n";
    }
    std::fwrite(out.data(), 1, out.size(), stdout);
    return allOk ? kExitDone : kExitSomeFailed;
}

} // namespace hexapose
