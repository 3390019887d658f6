// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/forward_solver.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/regression/polynomial_model.h"

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace hexapose {

/// A forward method by its word on the command line.
struct ForwardMethod {
    std::string_view word;  ///< "newton", "newton-as-published", "mpr2", "mpr3", "mpr2-nr", "mpr3-nr"
    std::string_view title; ///< as the field writes it: "Newton", "MPR3-NR", ...
    int modelDegree;        ///< degree of the regression it needs; 0: none
};

/// All six, the regression after Newton. The words and titles live as long as the program.
const std::vector<ForwardMethod>& forwardMethods();
/// nullptr for a word that is none.
const ForwardMethod* findForwardMethod(std::string_view word);

/// Builds the solver; `model` must be there, of the method's degree and of this platform, when the method
/// needs one. Throws InputError otherwise. The model is copied.
std::unique_ptr<ForwardSolver> makeForwardSolver(const ForwardMethod& method, const SharedModel& platform,
                                                 const PolynomialModel* model, const NewtonOptions& options);
std::unique_ptr<ForwardSolver> makeForwardSolver(const ForwardMethod& method,
                                                 const PlatformGeometry& geometry,
                                                 const PolynomialModel* model, const NewtonOptions& options);

} // namespace hexapose
