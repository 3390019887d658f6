// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/kinematics/forward_methods.h"

#include "core/geometry/input_error.h"
#include "core/kinematics/mpr_newton.h"

#include <algorithm>
#include <string>

namespace hexapose {

const std::vector<ForwardMethod>& forwardMethods() {
    static const std::vector<ForwardMethod> kMethods{
        {"newton", "Newton", 0},   {"newton-as-published", "Newton as published", 0},
        {"mpr2", "MPR2", 2},       {"mpr3", "MPR3", 3},
        {"mpr2-nr", "MPR2-NR", 2}, {"mpr3-nr", "MPR3-NR", 3},
    };
    return kMethods;
}

const ForwardMethod* findForwardMethod(std::string_view word) {
    const auto& methods = forwardMethods();
    const auto found = std::find_if(methods.begin(), methods.end(),
                                    [&](const ForwardMethod& method) { return method.word == word; });
    return found == methods.end() ? nullptr : &*found;
}

std::unique_ptr<ForwardSolver> makeForwardSolver(const ForwardMethod& method,
                                                 const PlatformGeometry& geometry,
                                                 const PolynomialModel* model, const NewtonOptions& options) {
    const std::string word(method.word);
    if (method.modelDegree == 0) {
        if (word == "newton")
            return std::make_unique<NewtonRaphson>(geometry, options);
        return std::make_unique<NewtonAsPublished>(geometry, options);
    }
    if (!model)
        throw InputError(word, "needs a regression model");
    if (model->spec.degree != method.modelDegree)
        throw InputError(word, "needs a model of degree " + std::to_string(method.modelDegree) + ", not " +
                                   std::to_string(model->spec.degree));
    if (model->platformFingerprint != geometry.fingerprint())
        throw InputError(word, "the model is of another platform");
    if (word.ends_with("-nr"))
        return std::make_unique<MprNewton>(geometry, *model, options);
    return std::make_unique<PolynomialRegression>(geometry, *model);
}

} // namespace hexapose
