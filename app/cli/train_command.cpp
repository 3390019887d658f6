// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/solver_choice.h"
#include "core/geometry/input_error.h"
#include "core/geometry/number_text.h"
#include "core/geometry/units.h"
#include "core/kinematics/polynomial_file.h"
#include "core/kinematics/polynomial_training.h"

#include <cstdio>
#include <limits>
#include <string>

namespace hexapose {

namespace {

constexpr std::int64_t kTestPoses = 10000;

void appendErrors(std::string& out, const char* name, const PoseVector& errors) {
    out += name;
    for (int k = 0; k < 6; ++k)
        out += "," + formatNumber(k < 3 ? mmFromMetres(errors[k]) : degFromRadians(errors[k]));
    out += "\n";
}

} // namespace

int trainCommand(const QStringList& words) {
    const Arguments arguments(
        "train", {},
        {{"degree", "D", "Degree of the polynomial, 1 to 4 (default: 3)."},
         {"range-mm", "R", "Displacements within +-R mm (default: from the platform's size)."},
         {"range-deg", "A", "Angles within +-A deg (default: from the platform)."},
         {"samples", "N", "Training poses (default: 100000)."},
         {"seed", "S", "Seed of the random poses (default: 1)."},
         {"out", "FILE", "The model file to write."}},
        words);
    const std::string file = arguments.requiredText("out");
    const PlatformGeometry platform = arguments.platform();
    const int degree = static_cast<int>(arguments.integer("degree", 3, 1, 4));
    TrainingSpec spec = defaultTrainingSpec(platform, degree);
    spec.offsetRange = metresFromMm(arguments.positive("range-mm", mmFromMetres(spec.offsetRange)));
    spec.angleRange = radiansFromDeg(arguments.positive("range-deg", degFromRadians(spec.angleRange)));
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
