// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/base/toml_values.h"

#include "core/base/input_error.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

long lineOf(const toml::source_region& region) {
    return std::max<long>(1, static_cast<long>(region.begin.line));
}

bool isControl(unsigned char c) {
    return c < 0x20 || c == 0x7f;
}

/// toml++ explains over several lines at times; a message here is one.
std::string oneLine(std::string_view text) {
    std::string line(text);
    std::replace_if(line.begin(), line.end(), isControl, ' ');
    return line;
}

} // namespace

toml::table parseToml(std::string_view text, const std::string& sourceName) {
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw InputError(sourceName, lineOf(error.source()), oneLine(error.description()));
    }
}

std::string tomlTypeName(const toml::node& node) {
    switch (node.type()) {
    case toml::node_type::string:
        return "text";
    case toml::node_type::integer:
        return "an integer";
    case toml::node_type::floating_point:
        return "a decimal number";
    case toml::node_type::boolean:
        return "true or false";
    case toml::node_type::array:
        return "a list";
    case toml::node_type::table:
        return "a table";
    default:
        return "a date or time";
    }
}

void TomlValues::fail(const toml::node& where, const std::string& cause) const {
    throw InputError(m_source, lineOf(where.source()), cause);
}

void TomlValues::refuseUnknown(const toml::table& table, const std::string& what,
                               std::initializer_list<std::string_view> known) const {
    const toml::node* first = nullptr;
    std::string name;
    for (const auto& [key, node] : table) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end())
            continue;
        if (first == nullptr || node.source().begin.line < first->source().begin.line) {
            first = &node;
            name = key.str();
        }
    }
    if (first != nullptr)
        fail(*first, what + "unknown key \"" + name + "\"");
}

void TomlValues::needFormat(const toml::table& root, std::int64_t format) const {
    const toml::node& node = need(root, "", "format");
    if (!node.is_integer())
        fail(node, "format is " + tomlTypeName(node) + ", not an integer");
    if (const auto number = node.value<std::int64_t>(); number != format)
        fail(node,
             "unknown format " + std::to_string(number.value_or(0)) + ", expected " + std::to_string(format));
}

const toml::node& TomlValues::need(const toml::table& table, const std::string& what,
                                   std::string_view key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr)
        fail(table, what + "missing key \"" + std::string(key) + "\"");
    return *node;
}

const toml::table& TomlValues::needTable(const toml::table& table, const std::string& what,
                                         std::string_view key) const {
    const toml::node& node = need(table, what, key);
    if (!node.is_table())
        fail(node, what + std::string(key) + " is " + tomlTypeName(node) + ", not a table");
    return *node.as_table();
}

double TomlValues::number(const toml::node& node, const std::string& name) const {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value)
        fail(node, name + " is " + tomlTypeName(node) + ", not a number");
    if (!std::isfinite(*value))
        fail(node, name + " is " + formatNumber(*value) + ", not a finite number");
    return *value;
}

Eigen::Vector3d TomlValues::vector(const toml::table& table, const std::string& what,
                                   std::string_view key) const {
    const toml::node& node = need(table, what, key);
    const std::string name = what + std::string(key);
    const toml::array* list = node.as_array();
    if (list == nullptr)
        fail(node, name + " is " + tomlTypeName(node) + ", not a list of three numbers");
    if (list->size() != 3)
        fail(node, name + " has " + std::to_string(list->size()) + " numbers, expected 3");
    Eigen::Vector3d values;
    for (std::size_t k = 0; k < 3; ++k)
        values[static_cast<Eigen::Index>(k)] = number(*list->get(k), name + "[" + std::to_string(k) + "]");
    return values;
}

std::string TomlValues::text(const toml::node& node, const std::string& name) const {
    const auto value = node.is_string() ? node.value<std::string>() : std::nullopt;
    if (!value)
        fail(node, name + " is " + tomlTypeName(node) + ", not text");
    if (std::any_of(value->begin(), value->end(), isControl))
        fail(node, name + " holds a line break or another control character");
    return *value;
}

} // namespace hexapose
