// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace hexapose {

/// Bad input from outside: a file, an option, a row. what() is one line, "where: what is wrong", where
/// "where" is a file name, "file:line", or an option.
class InputError : public std::runtime_error {
public:
    explicit InputError(const std::string& message) : std::runtime_error(message) {}
    InputError(const std::string& where, const std::string& cause)
        : std::runtime_error(where + ": " + cause) {}
    InputError(const std::string& file, long line, const std::string& cause)
        : std::runtime_error(file + ":" + std::to_string(line) + ": " + cause) {}
};

} // namespace hexapose
