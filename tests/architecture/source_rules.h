// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hexapose::architecture {

/// A folder of sources and what it may include beside itself: folders (with all below them that have no row
/// of their own) or single headers, as written after #include.
struct Layer {
    std::string_view folder;
    std::vector<std::string_view> mayInclude;
    bool mayUseQt = false;
};

/// The one table of allowed arrows. A folder without a row is an error, so that it gets one on purpose.
const std::vector<Layer>& layers();

/// What is wrong with one source, as "path:line: cause". path is relative to the top and decides which rules
/// hold; nothing is read from the disk.
std::vector<std::string> includeViolations(std::string_view path, std::string_view text);
std::vector<std::string> headerViolations(std::string_view path, std::string_view text);
std::vector<std::string> sizeViolations(std::string_view path, std::string_view text);
/// A folder's CMakeLists.txt: core links Qt only where it may.
std::vector<std::string> linkViolations(std::string_view path, std::string_view text);
/// A .cpp that the nearest CMakeLists.txt, at or above its folder, does not name. A test that is not named
/// there builds without a word and never runs.
std::vector<std::string> listViolations(std::string_view path, std::string_view listFolder,
                                        std::string_view list);

} // namespace hexapose::architecture
