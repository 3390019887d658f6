// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/base/text_file.h"

#include "core/base/input_error.h"

#include <fstream>
#include <sstream>

namespace hexapose {

std::string readTextFile(const std::filesystem::path& file) {
    std::error_code ignored;
    std::ifstream stream;
    if (!std::filesystem::is_directory(file, ignored)) // opening one succeeds, reading it throws
        stream.open(file, std::ios::binary);
    if (!stream.is_open())
        throw InputError(file.string(), "cannot be read");
    std::ostringstream text;
    if (stream.peek() != std::ifstream::traits_type::eof())
        text << stream.rdbuf();
    if (stream.bad())
        throw InputError(file.string(), "cannot be read");
    return std::move(text).str();
}

} // namespace hexapose
