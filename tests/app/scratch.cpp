// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace hexapose::apptest {

namespace fs = std::filesystem;

Scratch::Scratch() {
    std::string name = (fs::temp_directory_path() / "hexapose-app-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("no scratch directory");
    m_directory = name;
}

Scratch::~Scratch() {
    std::error_code ignored;
    fs::remove_all(m_directory, ignored);
}

std::string Scratch::file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
}

std::map<std::string, std::string> Scratch::contents() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(m_directory))
        all[entry.path().string()] = entry.is_regular_file() ? readText(entry.path()) : std::string();
    return all;
}

std::string readText(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

Table::Table(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> fields;
        std::string::size_type start = 0;
        for (std::string::size_type end = 0; end != std::string::npos; start = end + 1) {
            end = line.find(',', start);
            fields.push_back(line.substr(start, end == std::string::npos ? end : end - start));
        }
        if (header.empty())
            header = fields;
        else
            rows.push_back(fields);
    }
}

std::string Table::field(std::size_t row, const std::string& column) const {
    const auto found = std::find(header.begin(), header.end(), column);
    const auto index = static_cast<std::size_t>(found - header.begin());
    if (found == header.end() || row >= rows.size() || index >= rows[row].size()) {
        ADD_FAILURE() << "no field " << column << " in row " << row;
        return {};
    }
    return rows[row][index];
}

double Table::number(std::size_t row, const std::string& column) const {
    const std::string text = field(row, column);
    double value = std::nan("");
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

std::vector<double> Table::six(std::size_t row, const std::vector<std::string>& columns) const {
    std::vector<double> values;
    for (const std::string& column : columns)
        if (!field(row, column).empty())
            values.push_back(number(row, column));
    return values;
}

const std::vector<std::string>& lengthColumns() {
    static const std::vector<std::string> names{"l1_mm", "l2_mm", "l3_mm", "l4_mm", "l5_mm", "l6_mm"};
    return names;
}

const std::vector<std::string>& poseColumns() {
    static const std::vector<std::string> names{"x_mm", "y_mm", "z_mm", "alpha_deg", "beta_deg", "gamma_deg"};
    return names;
}

} // namespace hexapose::apptest
