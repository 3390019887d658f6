// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/kinematics/model_cache.h"

#include "core/geometry/fnv1a.h"
#include "core/geometry/input_error.h"
#include "core/kinematics/polynomial_file.h"

#include <string>
#include <system_error>

namespace hexapose {

namespace {

/// Platform, degree and the rest of the specification are in the name, so that models stand side by side.
std::string fileName(const PlatformGeometry& geometry, const TrainingSpec& spec) {
    Fnv1a hash;
    hash.add(spec.offsetRange);
    hash.add(spec.angleRange);
    hash.add(static_cast<std::uint64_t>(spec.samples));
    hash.add(spec.seed);
    return "model-" + geometry.fingerprint() + "-degree" + std::to_string(spec.degree) + "-" + hash.hex() +
           ".toml";
}

bool same(const TrainingSpec& a, const TrainingSpec& b) {
    return a.degree == b.degree && a.offsetRange == b.offsetRange && a.angleRange == b.angleRange &&
           a.samples == b.samples && a.seed == b.seed;
}

std::optional<PolynomialModel> loadCached(const std::filesystem::path& file, const PlatformGeometry& geometry,
                                          const TrainingSpec& spec) {
    try {
        PolynomialModel model = loadModel(file, geometry);
        if (same(model.spec, spec))
            return model;
    } catch (const InputError&) {
        // Not there, or damaged: it is trained anew and replaced.
    }
    return std::nullopt;
}

} // namespace

std::optional<CachedModel> loadOrTrainModel(const PlatformGeometry& geometry, const TrainingSpec& spec,
                                            const std::filesystem::path& directory,
                                            const TrainingProgress& progress) {
    CachedModel result;
    const std::filesystem::path file = directory / fileName(geometry, spec);
    if (std::optional<PolynomialModel> model = loadCached(file, geometry, spec)) {
        result.model = std::move(*model);
        result.file = file;
        return result;
    }
    std::optional<PolynomialModel> model = trainModel(geometry, spec, progress);
    if (!model)
        return std::nullopt;
    result.model = std::move(*model);
    result.trained = true;
    try {
        std::error_code ignored; // a directory that is not there shows when the file is written
        std::filesystem::create_directories(directory, ignored);
        saveModel(result.model, file);
        result.file = file;
    } catch (const InputError&) {
        // Only the reuse is lost.
    }
    return result;
}

} // namespace hexapose
