// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/log_metadata.h"

#include "core/base/csv_reader.h"
#include "core/base/input_error.h"
#include "core/base/utc_text.h"
#include "core/geometry/geometry_file.h"

#include <toml++/toml.h>

#include <sstream>

namespace hexapose {

namespace {

template <typename Node>
std::string tomlText(const Node& node) {
    std::ostringstream out;
    out << node;
    return out.str();
}

/// The platform file's keys moved under [platform]; its numbers stay as formatPlatform() wrote them.
std::string underPlatform(const std::string& platformToml) {
    std::istringstream lines(platformToml);
    std::string moved = "[platform]\n";
    for (std::string line; std::getline(lines, line);) {
        const std::size_t name = line.find_first_not_of('[');
        if (name == 1 || name == 2)
            line.insert(name, "platform.");
        moved += line + '\n';
    }
    return moved;
}

} // namespace

std::filesystem::path logMetadataFile(const std::filesystem::path& csvFile) {
    std::filesystem::path file = csvFile;
    if (file.extension() == ".gz")
        file.replace_extension();
    return file.replace_extension(".toml");
}

std::string formatLogMetadata(const LogMetadata& metadata, std::chrono::system_clock::time_point start) {
    std::string text = "# What the session log of the same name belongs to.\nformat = 1\n";
    const auto add = [&](const char* key, const std::string& value) {
        text += std::string(key) + " = " + tomlText(toml::value<std::string>(value)) + '\n';
    };
    add("program", "hexapose");
    add("program_version", metadata.programVersion);
    text += "start_time = " + formatUtc(start) + '\n';
    if (metadata.part > 1) {
        text += "part = " + std::to_string(metadata.part) + '\n';
        add("first_part", metadata.firstPart);
    }
    add("port", metadata.port);
    add("solver", metadata.solver);
    add("model_fingerprint", metadata.modelFingerprint);
    add("platform_fingerprint", metadata.platform.fingerprint());
    return text + '\n' + underPlatform(formatPlatform(metadata.platform));
}

RecordedMetadata readLogMetadata(const std::filesystem::path& tomlFile) {
    CsvSource source(tomlFile);
    toml::table root;
    try {
        root = toml::parse(source.stream(), source.name());
    } catch (const toml::parse_error& error) {
        throw InputError(source.name(), static_cast<long>(error.source().begin.line),
                         std::string(error.description()));
    }
    RecordedMetadata metadata;
    metadata.programVersion = root["program_version"].value_or(std::string());
    metadata.port = root["port"].value_or(std::string());
    metadata.solver = root["solver"].value_or(std::string());
    metadata.modelFingerprint = root["model_fingerprint"].value_or(std::string());
    metadata.platformFingerprint = root["platform_fingerprint"].value_or(std::string());
    if (const toml::table* platform = root["platform"].as_table())
        metadata.platform = parsePlatform(tomlText(*platform), source.name() + " [platform]");
    const std::string& recorded = metadata.platformFingerprint;
    if (metadata.platform && !recorded.empty() && metadata.platform->fingerprint() != recorded)
        throw InputError(source.name(), "the geometry under [platform] has the fingerprint " +
                                            metadata.platform->fingerprint() +
                                            ", not the platform_fingerprint " + recorded +
                                            " of the recording");
    return metadata;
}

} // namespace hexapose
