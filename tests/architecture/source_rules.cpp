// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "tests/architecture/source_rules.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <sstream>

namespace hexapose::architecture {
namespace {

constexpr long longestSource = 400; // lines

const Layer* layerOf(std::string_view path) {
    const Layer* best = nullptr;
    for (const Layer& layer : layers()) {
        const bool inside =
            path.starts_with(layer.folder) && path.substr(layer.folder.size()).starts_with('/');
        if (inside && (best == nullptr || layer.folder.size() > best->folder.size())) {
            best = &layer;
        }
    }
    return best;
}

bool inTopFolder(std::string_view path, std::string_view folder) {
    return path.starts_with(folder) && path.substr(folder.size()).starts_with('/');
}

bool mayInclude(const Layer& layer, std::string_view included) {
    const Layer* target = layerOf(included);
    if (target == &layer) {
        return true;
    }
    return std::any_of(layer.mayInclude.begin(), layer.mayInclude.end(), [&](std::string_view allowed) {
        return included == allowed || (target != nullptr && target->folder == allowed);
    });
}

bool isQtHeader(std::string_view header) {
    static const std::regex pattern("Q[A-Za-z0-9]+(/.*)?|q[a-z0-9_]+\\.h");
    return std::regex_match(header.begin(), header.end(), pattern);
}

/// TOML is for the sources that read and write files; their headers show our own types.
bool mayUseToml(std::string_view path) {
    static const std::regex pattern("core/.*/([a-z0-9_]+_file|log_[a-z0-9_]+)\\.cpp");
    return path.starts_with("core/base/toml_values.") || std::regex_match(path.begin(), path.end(), pattern);
}

/// ui/charts/time_chart.cpp: moc_time_chart.cpp.
std::string mocOutputOf(std::string_view path) {
    return "moc_" + std::string(path.substr(path.find_last_of('/') + 1));
}

std::optional<std::string> judge(const Layer& layer, std::string_view path, std::string_view header,
                                 bool quoted) {
    const std::string name(header);
    if (isQtHeader(header) && !layer.mayUseQt) {
        return std::string(layer.folder) + " must not use Qt: " + name;
    }
    if ((header.starts_with("toml") || header == "core/base/toml_values.h") && !mayUseToml(path)) {
        return "only the sources of files (*_file.cpp, log_*.cpp) read TOML: " + name;
    }
    const bool ours = inTopFolder(header, "core") || inTopFolder(header, "ui") ||
                      inTopFolder(header, "app") || inTopFolder(header, "tests");
    if (ours) {
        return mayInclude(layer, header)
                   ? std::nullopt
                   : std::optional(std::string(layer.folder) + " must not include " + name);
    }
    // A shorter name would get round the table. Only moc's output has no folder: the source that it belongs
    // to takes it in, as it has read the same headers already.
    if (quoted && name != mocOutputOf(path)) {
        return "name the header from the top folder: " + name;
    }
    return std::nullopt;
}

std::string at(std::string_view path, long line, const std::string& cause) {
    return std::string(path) + ":" + std::to_string(line) + ": " + cause;
}

} // namespace

std::vector<std::string> includeViolations(std::string_view path, std::string_view text) {
    static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    const Layer* layer = layerOf(path);
    if (layer == nullptr) {
        return {at(path, 1, "this folder has no row in the table of allowed includes")};
    }
    std::vector<std::string> found;
    std::istringstream in{std::string(text)};
    std::string line;
    for (long number = 1; std::getline(in, line); ++number) {
        std::smatch match;
        if (!std::regex_match(line, match, pattern)) {
            continue;
        }
        if (const auto cause = judge(*layer, path, match[2].str(), match[1].str() == "\"")) {
            found.push_back(at(path, number, *cause));
        }
    }
    return found;
}

std::vector<std::string> headerViolations(std::string_view path, std::string_view text) {
    const bool gpl = inTopFolder(path, "ui") || inTopFolder(path, "app") || inTopFolder(path, "tests/ui") ||
                     inTopFolder(path, "tests/app");
    const std::string wanted = gpl ? "GPL-3.0-or-later" : "MIT";
    const std::string header =
        "// SPDX-FileCopyrightText: 2026 The Hexapose authors\n// SPDX-License-Identifier: ";
    if (text.starts_with(header + wanted + "\n")) {
        return {};
    }
    return {at(path, 1, "does not start with its two SPDX lines, licence " + wanted)};
}

std::vector<std::string> sizeViolations(std::string_view path, std::string_view text) {
    const auto lines = std::count(text.begin(), text.end(), '\n');
    if (lines <= longestSource) {
        return {};
    }
    return {at(path, longestSource + 1,
               std::to_string(lines) + " lines, more than " + std::to_string(longestSource))};
}

std::vector<std::string> linkViolations(std::string_view path, std::string_view text) {
    const Layer* layer = layerOf(path);
    if (layer == nullptr || layer->mayUseQt || text.find("Qt6::") == std::string_view::npos) {
        return {};
    }
    return {at(path, 1, std::string(layer->folder) + " must not link Qt")};
}

std::vector<std::string> listViolations(std::string_view path, std::string_view listFolder,
                                        std::string_view list) {
    std::string name(path.substr(listFolder.size() + 1));
    if (listFolder == "tests/examples") {
        name = name.substr(0, name.find('.')); // a program each, called by its name
    }
    static const std::regex comments("#[^\n]*");
    static const std::regex separators("[\\s()\"]+");
    const std::string text = std::regex_replace(std::string(list), comments, "");
    const std::sregex_token_iterator end;
    for (std::sregex_token_iterator word(text.begin(), text.end(), separators, -1); word != end; ++word) {
        if (word->str() == name || word->str() == name + ".cpp") {
            return {};
        }
    }
    return {at(path, 1, "is not named in " + std::string(listFolder) + "/CMakeLists.txt")};
}

} // namespace hexapose::architecture
