// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hexapose::apptest {

/// A directory of one test, gone with it.
class Scratch {
public:
    Scratch();
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::string path(const std::string& name) const { return (m_directory / name).string(); }
    /// Writes the file and returns its path.
    std::string file(const std::string& name, const std::string& text) const;
    /// Every file and what is in it.
    std::map<std::string, std::string> contents() const;

private:
    std::filesystem::path m_directory;
};

std::string readText(const std::filesystem::path& file);

/// A table with a header row, read plainly: no field of ours holds a comma or a quote.
struct Table {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;

    explicit Table(const std::string& text);
    /// "" and a test failure for a column that is not there.
    std::string field(std::size_t row, const std::string& column) const;
    double number(std::size_t row, const std::string& column) const;
    /// Six numbers of columns; empty when the first of the fields is.
    std::vector<double> six(std::size_t row, const std::vector<std::string>& columns) const;
};

const std::vector<std::string>& lengthColumns();
const std::vector<std::string>& poseColumns();

} // namespace hexapose::apptest
