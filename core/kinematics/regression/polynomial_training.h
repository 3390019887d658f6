// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/kinematics/regression/polynomial_model.h"

#include <functional>
#include <optional>

namespace hexapose {

/// Called from the calling thread now and then with the part done, 0 to 1; return false to cancel.
using TrainingProgress = std::function<bool(double)>;

/// Fits a model by least squares to Monte Carlo poses (Eq. 17 on distinct monomials). The result depends on
/// the specification alone, not on the number of threads. threads: 0 for one a core. Nothing when cancelled.
/// Throws InputError for a specification that cannot be fitted (degree outside 1..4, a range that is not
/// positive and finite, unless both are 0, fewer samples than monomials, lengths of zero, a singular
/// geometry).
std::optional<PolynomialModel> trainModel(const PlatformGeometry& geometry, const TrainingSpec& spec,
                                          const TrainingProgress& progress = {}, unsigned threads = 0);

/// Mean absolute and largest error of the plain regression over fresh random poses, each coordinate for
/// itself.
struct ModelErrors {
    PoseVector meanAbsolute = PoseVector::Zero(); ///< m, rad
    PoseVector largest = PoseVector::Zero();      ///< m, rad
};
/// Over `samples` poses of the box that the model was trained on; other ones than in training, even of the
/// same seed.
ModelErrors testModel(const PlatformGeometry& geometry, const PolynomialModel& model, std::int64_t samples,
                      std::uint64_t seed);

} // namespace hexapose
