// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/cli/solver_choice.h"
#include "app/common/arguments.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text_file.h"
#include "core/base/units.h"
#include "core/kinematics/regression/polynomial_file.h"
#include "core/kinematics/regression/polynomial_training.h"

#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

namespace hexapose {

namespace {

constexpr std::int64_t kTestPoses = 10000;
constexpr double kMostDeg = 90.0;                               ///< of the angles' range; beta has no more
constexpr std::string_view kModelEnd = "checksum = \"fnv1a64:"; ///< begins the last line of a model file

/// A model may take the place of a model, and of nothing else: training ends by renaming over the file.
void checkOut(const std::string& file) {
    std::error_code error;
    if (!std::filesystem::exists(std::filesystem::symlink_status(file, error)))
        return;
    const std::string cause = "exists, and is not a regression model; it is not written over";
    if (!std::filesystem::is_regular_file(file, error))
        throw InputError(file, cause);
    const std::string text = readTextFile(file);
    const std::size_t lastLine = text.rfind('\n', text.size() < 2 ? 0 : text.size() - 2);
    if (lastLine == std::string::npos || text.compare(lastLine + 1, kModelEnd.size(), kModelEnd) != 0)
        throw InputError(file, cause);
}

void appendErrors(std::string& out, const char* name, const PoseVector& errors) {
    out += name;
    for (int k = 0; k < 6; ++k)
        out += "," + formatNumber(k < 3 ? mmFromMetres(errors[k]) : degFromRadians(errors[k]));
    out += "\n";
}

} // namespace

Usage trainUsage() {
    return {"hexapose-cli train",
            {},
            {{"degree", "D", "Degree of the polynomial, 1 to 4 (default: 3)."},
             {"range-mm", "R", "Displacements within +-R mm (default: from the platform's size)."},
             {"range-deg", "A", "Angles within +-A deg (default: from the platform)."},
             {"samples", "N", "Training poses (default: 100000)."},
             {"seed", "S", "Seed of the random poses (default: 1)."},
             {"out", "FILE", "The model file to write; never overwrites a file that is not a model."}}};
}

int trainCommand(const Arguments& arguments) {
    const std::string file = arguments.requiredText("out");
    checkOut(file);
    const PlatformGeometry platform = arguments.platform();
    const int degree = static_cast<int>(arguments.integer("degree", 3, 1, 4));
    TrainingSpec spec = defaultTrainingSpec(platform, degree);
    spec.offsetRange = metresFromMm(arguments.positive("range-mm", mmFromMetres(spec.offsetRange)));
    spec.angleRange = radiansFromDeg(arguments.positive("range-deg", degFromRadians(spec.angleRange)));
    if (degFromRadians(spec.angleRange) > kMostDeg * (1.0 + 1e-12))
        throw InputError("--range-deg", "'" + arguments.text("range-deg", "") + "' is more than 90");
    spec.samples = arguments.integer("samples", spec.samples, 1, 1000000000);
    spec.seed =
        static_cast<std::uint64_t>(arguments.integer("seed", 1, 0, std::numeric_limits<std::int64_t>::max()));
    const auto model = trainModel(platform, spec, [](double part) { return showProgress("training", part); });
    saveModel(*model, file);

    const ModelErrors errors = testModel(platform, *model, kTestPoses, spec.seed + 1);
    std::string out = "error,x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg\n";
    appendErrors(out, "mean_absolute", errors.meanAbsolute);
    appendErrors(out, "largest", errors.largest);
    std::fwrite(out.data(), 1, out.size(), stdout);
    return kExitDone;
}

} // namespace hexapose
