// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/arguments.h"
#include "core/finite_step/path_fallback.h"
#include "core/finite_step/step_form.h"
#include "core/geometry/platform_geometry.h"
#include "core/kinematics/catalog/forward_methods.h"
#include "core/kinematics/forward_solver.h"

#include <memory>
#include <string>
#include <vector>

namespace hexapose {

struct ChosenSolver {
    std::shared_ptr<const ForwardSolver> solver;
    std::string modelFingerprint; ///< empty: no model

    /// Of MPR-NR: the solver again, as the one that can tell whether it followed a path. Else null.
    const PathFallback* fallback() const { return dynamic_cast<const PathFallback*>(solver.get()); }
};

/// What --method knows.
std::vector<std::string> methodWords();

/// A command's own options, and those that chooseSolver() reads.
std::vector<OptionSpec> withSolverOptions(std::vector<OptionSpec> own);

/// The solver, MPR-NR with its fallback, of --method, --model, --tolerance-mm, --max-iterations, --steps and
/// --form. A method that needs a model gets the one of --model, or the platform's own, trained on first use
/// with a progress bar on a terminal.
/// A platform that is singular at home, or too close to it for a model, is refused, or gets Newton, which
/// reports in each row what it can say.
enum class SingularHome { Refused, Allowed };
/// Whether --tolerance-mm is the solver's, or the command's own.
enum class SolverTolerance { Option, Default };
ChosenSolver chooseSolver(const Arguments& arguments, const PlatformGeometry& platform,
                          SingularHome singularHome = SingularHome::Refused,
                          SolverTolerance tolerance = SolverTolerance::Option);

/// The solver of a method with its default options and the platform's own model.
ChosenSolver makeDefaultSolver(const ForwardMethod& method, const PlatformGeometry& platform);

/// --form of finite-step integration.
StepForm stepForm(const Arguments& arguments, StepForm fallback);

/// A progress bar on standard error, only where that is a terminal. Returns true, so that it can serve as a
/// callback.
bool showProgress(const std::string& label, double part);

} // namespace hexapose
