// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <toml++/toml.h>

#include <initializer_list>
#include <string>
#include <string_view>

namespace hexapose {

/// Text of a TOML file as its tree. Throws InputError with the line where it is not TOML.
toml::table parseToml(std::string_view text, const std::string& sourceName);

/// What is common to reading every file of ours. Every complaint is an InputError with the line it is about;
/// `what` is the place inside the file, as "leg 3: ", and comes first in the text.
class TomlValues {
public:
    /// Keeps a reference to the name.
    explicit TomlValues(const std::string& sourceName) : m_source(sourceName) {}

    [[noreturn]] void fail(const toml::node& where, const std::string& cause) const;
    /// Reports the first in the file.
    void refuseUnknown(const toml::table& table, const std::string& what,
                       std::initializer_list<std::string_view> known) const;
    /// The key `format` with this number.
    void needFormat(const toml::table& root, std::int64_t format) const;
    const toml::node& need(const toml::table& table, const std::string& what, std::string_view key) const;
    const toml::table& needTable(const toml::table& table, const std::string& what,
                                 std::string_view key) const;
    /// A finite number.
    double number(const toml::node& node, const std::string& name) const;
    /// Three finite numbers.
    Eigen::Vector3d vector(const toml::table& table, const std::string& what, std::string_view key) const;
    /// Text without control characters: it goes into messages of one line.
    std::string text(const toml::node& node, const std::string& name) const;

private:
    const std::string& m_source;
};

/// "text", "an integer", ...: for messages that name what was found in place of what was expected.
std::string tomlTypeName(const toml::node& node);

} // namespace hexapose
