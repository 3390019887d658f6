// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/input_error.h"
#include "core/record/log_writer.h"

#include <array>
#include <ctime>
#include <system_error>

namespace hexapose {

std::filesystem::path newLogFile(const std::filesystem::path& directory,
                                 std::chrono::system_clock::time_point now) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error || !std::filesystem::is_directory(directory))
        throw InputError(directory.string(),
                         "cannot be created: " + (error ? error.message() : std::string("not a directory")));
    const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
    std::tm local{};
    localtime_r(&seconds, &local);
    std::array<char, 64> stem{};
    std::strftime(stem.data(), stem.size(), "hexapose-%Y%m%d-%H%M%S", &local);

    std::filesystem::path file = directory / (std::string(stem.data()) + ".csv");
    for (int number = 2;
         std::filesystem::exists(file, error) || std::filesystem::exists(logMetadataFile(file), error);
         ++number)
        file = directory / (std::string(stem.data()) + "-" + std::to_string(number) + ".csv");
    return file;
}

} // namespace hexapose
