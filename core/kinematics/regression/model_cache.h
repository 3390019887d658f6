// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/regression/polynomial_model.h"
#include "core/kinematics/regression/polynomial_training.h"

#include <filesystem>
#include <optional>

namespace hexapose {

/// A model, and where it comes from.
struct CachedModel {
    PolynomialModel model;
    bool trained = false;       ///< false: read from the cache
    std::filesystem::path file; ///< empty when it could not be kept
};

/// The model of this platform and specification from `directory`, or trained now and kept there. A cached
/// file that is damaged is trained anew and replaced. A directory that cannot be written costs only the
/// reuse. Nothing when cancelled. Throws what trainModel() throws.
std::optional<CachedModel> loadOrTrainModel(const PlatformGeometry& geometry, const TrainingSpec& spec,
                                            const std::filesystem::path& directory,
                                            const TrainingProgress& progress = {});

} // namespace hexapose
