// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace hexapose {

/// What stands beside the log, in a file of the same name with the ending .toml.
struct LogMetadata {
    PlatformGeometry platform;
    std::string modelFingerprint; ///< empty: no model
    std::string solver;           ///< method word
    std::string programVersion;
    std::string port;      ///< "virtual" or a path
    int part = 1;          ///< of the log
    std::string firstPart; ///< its file name; of the others
};

/// The file beside a log that records what it belongs to: run.csv -> run.toml, and run.csv.gz -> run.toml.
std::filesystem::path logMetadataFile(const std::filesystem::path& csvFile);
/// Its text; the platform stands under [platform] as in a platform file.
std::string formatLogMetadata(const LogMetadata& metadata, std::chrono::system_clock::time_point start);

/// The same read back. A file by another program may hold less.
struct RecordedMetadata {
    std::optional<PlatformGeometry> platform;
    std::string platformFingerprint;
    std::string modelFingerprint;
    std::string solver;
    std::string programVersion;
    std::string port;
};
/// Throws InputError "file:line: cause" for bad TOML, a platform that cannot be used, or one that is not that
/// of the fingerprint.
RecordedMetadata readLogMetadata(const std::filesystem::path& tomlFile);

} // namespace hexapose
