// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/regression/model_cache.h"

#include "core/base/input_error.h"
#include "core/kinematics/regression/polynomial_file.h"

#include <utility>

namespace hexapose {

namespace {

std::optional<PolynomialModel> cachedModel(const std::filesystem::path& file,
                                           const PlatformGeometry& geometry, const TrainingSpec& spec) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return std::nullopt;
    try {
        PolynomialModel model = loadModel(file, geometry);
        if (specFingerprint(model.spec) == specFingerprint(spec))
            return model;
    } catch (const InputError&) {
        // Damaged: the caller trains it anew, which also replaces the file.
    }
    return std::nullopt;
}

bool keep(const PolynomialModel& model, const std::filesystem::path& file) {
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    try {
        saveModel(model, file);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

} // namespace

std::optional<CachedModel> loadOrTrainModel(const PlatformGeometry& geometry, const TrainingSpec& wanted,
                                            const std::filesystem::path& directory,
                                            const TrainingProgress& progress) {
    const TrainingSpec spec = withDefaults(wanted, geometry);
    const std::filesystem::path file =
        directory / ("mpr" + std::to_string(spec.degree) + '-' + geometry.fingerprint() + '-' +
                     specFingerprint(spec) + ".toml");
    if (auto model = cachedModel(file, geometry, spec))
        return CachedModel{std::move(*model), false, file};
    auto model = trainModel(geometry, spec, progress);
    if (!model)
        return std::nullopt;
    const bool kept = keep(*model, file);
    return CachedModel{std::move(*model), true, kept ? file : std::filesystem::path{}};
}

} // namespace hexapose
