// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/solver_choice.h"

#include "app/common/directories.h"
#include "core/base/input_error.h"
#include "core/base/units.h"
#include "core/finite_step/finite_step_solver.h"
#include "core/kinematics/catalog/forward_methods.h"
#include "core/kinematics/regression/model_cache.h"
#include "core/kinematics/regression/polynomial_file.h"

#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace hexapose {

namespace {

/// The one method that is not of core/kinematics.
constexpr const char* kFiniteSteps = "fsi";
constexpr std::int64_t kMostSteps = 10000000;

const ForwardMethod& chooseMethod(const std::string& word) {
    if (const ForwardMethod* method = findForwardMethod(word))
        return *method;
    std::string known;
    for (const std::string& each : methodWords())
        known += (known.empty() ? "" : ", ") + each;
    throw InputError("--method", "unknown method '" + word + "' (known: " + known + ")");
}

PolynomialModel ownModel(const PlatformGeometry& platform, const ForwardMethod& method) {
    const TrainingSpec spec = defaultTrainingSpec(platform, method.modelDegree);
    auto cached = loadOrTrainModel(platform, spec, cacheDirectory(),
                                   [](double part) { return showProgress("training the model", part); });
    return std::move(cached->model); // never cancelled here
}

PolynomialModel givenModel(const std::string& file, const PlatformGeometry& platform,
                           const ForwardMethod& method) {
    PolynomialModel model = loadModel(file, platform);
    if (model.spec.degree != method.modelDegree)
        throw InputError(file, "a model of degree " + std::to_string(model.spec.degree) + ", but " +
                                   std::string(method.word) + " needs degree " +
                                   std::to_string(method.modelDegree));
    return model;
}

ChosenSolver withModel(const ForwardMethod& method, const PlatformGeometry& platform,
                       const PolynomialModel& model, const NewtonOptions& options, bool limitGiven = false) {
    PathFallbackOptions fallback;
    fallback.tolerance = options.tolerance;
    fallback.afterIterationLimit = !limitGiven; // who gives one wants to see what it does
    const SharedModel shared = makeModel(platform);
    return {withPathFallback(method, shared, makeForwardSolver(method, shared, &model, options), fallback),
            model.fingerprint()};
}

void refuseOption(const Arguments& arguments, const char* option, const std::string& cause) {
    if (arguments.has(option))
        throw InputError(std::string("--") + option, cause);
}

ChosenSolver finiteStepSolver(const Arguments& arguments, const PlatformGeometry& platform,
                              double tolerance) {
    refuseOption(arguments, "model", "method fsi uses no model");
    refuseOption(arguments, "max-iterations", "method fsi does not iterate, it takes --steps");
    FiniteStepOptions options;
    options.tolerance = tolerance;
    options.steps = static_cast<int>(arguments.integer("steps", options.steps, 1, kMostSteps));
    options.form = stepForm(arguments, options.form);
    return {std::make_unique<FiniteStepSolver>(platform, options), {}};
}

ChosenSolver choose(const Arguments& arguments, const PlatformGeometry& platform, bool modelPossible,
                    double tolerance) {
    const std::string word = arguments.text("method", "mpr3-nr");
    if (word == kFiniteSteps)
        return finiteStepSolver(arguments, platform, tolerance);
    const ForwardMethod& method = chooseMethod(word);
    for (const char* option : {"steps", "form"})
        refuseOption(arguments, option, "method " + word + " takes no steps");
    NewtonOptions options;
    options.tolerance = tolerance;
    options.maxIterations =
        static_cast<int>(arguments.integer("max-iterations", options.maxIterations, 1, 1000000));
    if (method.modelDegree == 0) {
        refuseOption(arguments, "model", "method " + word + " uses no model");
        return {makeForwardSolver(method, platform, nullptr, options), {}};
    }
    if (!modelPossible && !arguments.has("model"))
        return {std::make_unique<NewtonRaphson>(platform, options), {}};
    const PolynomialModel model = arguments.has("model")
                                      ? givenModel(arguments.requiredText("model"), platform, method)
                                      : ownModel(platform, method);
    return withModel(method, platform, model, options, arguments.has("max-iterations"));
}

bool hasModel(const PlatformGeometry& platform) {
    try {
        defaultTrainingSpec(platform, 1);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

} // namespace

StepForm stepForm(const Arguments& arguments, StepForm fallback) {
    const std::string word = arguments.text("form", std::string(toWord(fallback)).c_str());
    const std::optional<StepForm> form = stepFormFromWord(word);
    if (!form)
        throw InputError("--form", "'" + word + "' is none of open, closed and corrected");
    return *form;
}

std::vector<std::string> methodWords() {
    std::vector<std::string> words;
    for (const ForwardMethod& method : forwardMethods())
        words.emplace_back(method.word);
    words.emplace_back(kFiniteSteps);
    return words;
}

std::vector<OptionSpec> withSolverOptions(std::vector<OptionSpec> own) {
    own.insert(own.end(), {{"method", "M", "Forward method, as in 'forward'.", methodWords()},
                           {"model", "FILE", "Regression model, as in 'forward'."},
                           {"tolerance-mm", "T", "Largest residual of a solution, as in 'forward'."},
                           {"max-iterations", "N", "Most Newton iterations, as in 'forward'."},
                           {"steps", "N", "Steps of fsi, as in 'forward'."},
                           {"form", "open|closed|corrected", "Form of a step of fsi, as in 'forward'."}});
    return own;
}

ChosenSolver chooseSolver(const Arguments& arguments, const PlatformGeometry& platform,
                          SingularHome singularHome, SolverTolerance tolerance) {
    return choose(arguments, platform, singularHome == SingularHome::Refused || hasModel(platform),
                  tolerance == SolverTolerance::Option ? metresFromMm(arguments.positive("tolerance-mm", 0.0))
                                                       : 0.0);
}

ChosenSolver makeDefaultSolver(const ForwardMethod& method, const PlatformGeometry& platform) {
    if (method.modelDegree == 0)
        return {makeForwardSolver(method, platform, nullptr, NewtonOptions{}), {}};
    return withModel(method, platform, ownModel(platform, method), NewtonOptions{});
}

bool showProgress(const std::string& label, double part) {
    if (isatty(STDERR_FILENO) == 0)
        return true;
    constexpr int kWidth = 40;
    const int filled = static_cast<int>(std::lround(part * kWidth));
    std::fprintf(stderr, "\r%s [%s%s] %3.0f %%%s", label.c_str(),
                 std::string(static_cast<std::size_t>(filled), '#').c_str(),
                 std::string(static_cast<std::size_t>(kWidth - filled), ' ').c_str(), 100.0 * part,
                 part >= 1.0 ? "\n" : "");
    std::fflush(stderr);
    return true;
}

} // namespace hexapose
