// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace hexapose {

/// What is wrong with a file, as values: what() of the error has words for it, a screen has its own. In
/// brackets the details.
struct InputFault {
    enum class Kind {
        Exists,     ///< and is not overwritten
        NotCreated, ///< [the system's words]
        NotWritten, ///< [the system's words]
        NotRead,    ///< [the system's words]
        NotReadFurther,
        Directory,
        Empty,
        OpenQuote,
        NotUtf8,
        ColumnMissing, ///< [its name]
        NoCommas,      ///< the same, because fields are separated otherwise [its name]
        ColumnTwice,   ///< [its name]
        LastLineIncomplete,
        FieldCount, ///< [of the row, of the header]
        NotFinite,  ///< [column, text]
        NoPoses,
    };
    Kind kind;
    std::string where;
    long line = 0; ///< 1-based; 0: the whole file
    std::vector<std::string> details = {};
};

/// Bad input from outside: a file, an option, a row. what() is one line, "where: what is wrong", where
/// "where" is a file name, "file:line", or an option.
class InputError : public std::runtime_error {
public:
    explicit InputError(const std::string& message) : std::runtime_error(message) {}
    InputError(const std::string& where, const std::string& cause)
        : std::runtime_error(where + ": " + cause) {}
    InputError(const std::string& file, long line, const std::string& cause)
        : std::runtime_error(file + ":" + std::to_string(line) + ": " + cause) {}
    explicit InputError(InputFault fault);

    /// Null where there are only words.
    const InputFault* fault() const { return m_fault.get(); }

private:
    std::shared_ptr<const InputFault> m_fault; ///< shared: a copy of an error cannot fail
};

} // namespace hexapose
