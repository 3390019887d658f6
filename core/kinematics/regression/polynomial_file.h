// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/regression/polynomial_model.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace hexapose {

/// Model file: TOML text (format, platform fingerprint, ranges, degree, samples, seed, scaling, coefficients)
/// whose last line is a checksum of every byte before it. Written to a temporary name and renamed, so that a
/// reader never sees half a file. Throws InputError "file: cannot be written".
void saveModel(const PolynomialModel& model, const std::filesystem::path& file);
/// Its text.
std::string formatModel(const PolynomialModel& model);

/// Throws InputError "file: cause" for a file that cannot be read, is truncated or altered (checksum), has an
/// unknown format, or does not belong to this geometry.
PolynomialModel loadModel(const std::filesystem::path& file, const PlatformGeometry& geometry);
/// The same from text; sourceName stands for the file in messages.
PolynomialModel parseModel(std::string_view text, const std::string& sourceName,
                           const PlatformGeometry& geometry);

} // namespace hexapose
