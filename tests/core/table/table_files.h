// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/table_loader.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace hexapose::testing_support {

/// A folder of the running test, which goes with it.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
    /// A file of this content.
    std::filesystem::path write(const std::string& name, const std::string& content) const;

private:
    std::filesystem::path m_path;
};

/// A table of a file of this content.
std::shared_ptr<const Table> tableOf(const std::string& content, const std::string& name = "t.csv");
/// The numbers of a column, by its name.
std::vector<double> numbersOf(const Table& table, const std::string& column);
std::vector<std::string> wordsOf(const Table& table, const std::string& column);
/// "4: l1_mm: \"abc\" is not a number", line by line.
std::vector<std::string> problemsOf(const Table& table);
std::vector<std::string> namesOf(const Table& table);

/// Every cell, line and problem.
void expectSame(const Table& a, const Table& b);

std::string gzip(const std::string& text);
std::string utf16(const std::string& ascii, bool bigEndian);

} // namespace hexapose::testing_support
