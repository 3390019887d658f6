// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/common/directories.h"

#include "core/base/input_error.h"

#include <array>
#include <cstdlib>
#include <set>
#include <system_error>

namespace hexapose {

namespace fs = std::filesystem;

namespace {

fs::path fromEnvironment(const char* variable, const char* belowHome) {
    const char* value = std::getenv(variable);
    if (value && *value == '/') // the XDG specification: relative paths are to be ignored
        return value;
    const char* home = std::getenv("HOME");
    return home && *home ? fs::path(home) / belowHome : fs::temp_directory_path();
}

fs::path programDirectory() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return error ? fs::current_path() : program.parent_path();
}

/// Of an installed program, and of one in build/<preset>/bin.
std::array<fs::path, 2> shippedFolders(const std::string& folder) {
    const fs::path bin = programDirectory();
    return {(bin / "../share/hexapose" / folder).lexically_normal(),
            (bin / "../../../resources" / folder).lexically_normal()};
}

/// A file by its path, or by its name one of those that come with the program.
fs::path findShipped(const std::string& nameOrFile, const std::string& what, const std::string& folder,
                     const char* option) {
    std::error_code error;
    if (fs::exists(nameOrFile, error))
        return nameOrFile;
    if (nameOrFile.empty() || nameOrFile.find('/') != std::string::npos ||
        fs::path(nameOrFile).has_extension())
        throw InputError(nameOrFile.empty() ? option : nameOrFile, "no such " + what + " file");
    const auto [installed, sourceTree] = shippedFolders(folder);
    for (const fs::path& directory : {installed, sourceTree}) {
        fs::path file = directory / (nameOrFile + ".toml");
        if (fs::exists(file, error))
            return file;
    }
    // The folder that there is: an installed program has nothing to tell of a source tree.
    const fs::path& shown = fs::exists(sourceTree, error) ? sourceTree : installed;
    throw InputError(nameOrFile, "no such " + what + " file, and none of this name in " + shown.string());
}

} // namespace

void makeDirectory(const fs::path& directory) {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error)
        throw InputError(directory.string(), "cannot be made: " + error.message());
}

fs::path cacheDirectory() {
    return fromEnvironment("XDG_CACHE_HOME", ".cache") / "hexapose";
}

fs::path defaultLogDirectory() {
    return fromEnvironment("XDG_DATA_HOME", ".local/share") / "hexapose" / "logs";
}

fs::path findPlatformFile(const std::string& nameOrFile) {
    return findShipped(nameOrFile, "platform", "platforms", "--platform");
}

fs::path findMechanismFile(const std::string& nameOrFile) {
    return findShipped(nameOrFile, "mechanism", "mechanisms", "--mechanism");
}

std::vector<std::string> shippedNames(const std::string& folder) {
    std::set<std::string> names;
    for (const fs::path& directory : shippedFolders(folder)) {
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(directory, error))
            if (entry.path().extension() == ".toml")
                names.insert(entry.path().stem().string());
    }
    return {names.begin(), names.end()};
}

} // namespace hexapose
