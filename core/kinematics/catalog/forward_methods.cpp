// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/catalog/forward_methods.h"

#include "core/base/input_error.h"
#include "core/kinematics/regression/mpr_newton.h"

#include <algorithm>
#include <string>

namespace hexapose {

namespace {

const PolynomialModel& checkedModel(const ForwardMethod& method, const PlatformModel& platform,
                                    const PolynomialModel* model) {
    const std::string where = "method " + std::string(method.word);
    if (model == nullptr)
        throw InputError(where, "needs a regression model of degree " + std::to_string(method.modelDegree));
    if (model->spec.degree != method.modelDegree)
        throw InputError(where, "needs a regression model of degree " + std::to_string(method.modelDegree) +
                                    ", this one has degree " + std::to_string(model->spec.degree));
    if (model->platformFingerprint != platform.fingerprint())
        throw InputError(where, "the model belongs to platform " + model->platformFingerprint +
                                    ", this platform is " + platform.fingerprint());
    return *model;
}

} // namespace

const std::vector<ForwardMethod>& forwardMethods() {
    static const std::vector<ForwardMethod> methods{
        {"newton", "Newton", 0},   {"newton-as-published", "Newton as published", 0},
        {"mpr2", "MPR2", 2},       {"mpr3", "MPR3", 3},
        {"mpr2-nr", "MPR2-NR", 2}, {"mpr3-nr", "MPR3-NR", 3},
    };
    return methods;
}

const ForwardMethod* findForwardMethod(std::string_view word) {
    const auto& methods = forwardMethods();
    const auto found = std::find_if(methods.begin(), methods.end(),
                                    [&](const ForwardMethod& method) { return method.word == word; });
    return found == methods.end() ? nullptr : &*found;
}

std::unique_ptr<ForwardSolver> makeForwardSolver(const ForwardMethod& method, const SharedModel& platform,
                                                 const PolynomialModel* model, const NewtonOptions& options) {
    if (method.word == "newton")
        return std::make_unique<NewtonRaphson>(platform, options);
    if (method.word == "newton-as-published")
        return std::make_unique<NewtonAsPublished>(platform, options);
    const PolynomialModel& checked = checkedModel(method, *platform, model);
    if (method.word.ends_with("-nr"))
        return std::make_unique<MprNewton>(platform, checked, options);
    return std::make_unique<PolynomialRegression>(platform, checked);
}

std::unique_ptr<ForwardSolver> makeForwardSolver(const ForwardMethod& method,
                                                 const PlatformGeometry& geometry,
                                                 const PolynomialModel* model, const NewtonOptions& options) {
    return makeForwardSolver(method, makeModel(geometry), model, options);
}

} // namespace hexapose
