// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/append_file.h"

#include "core/base/input_error.h"

#include <cerrno>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace hexapose {

AppendFile::AppendFile(const std::filesystem::path& file)
    : m_descriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644)) {
    if (m_descriptor >= 0)
        return;
    if (errno == EEXIST)
        throw InputError(InputFault{InputFault::Kind::Exists, file.string()});
    throw InputError(
        InputFault{InputFault::Kind::NotCreated, file.string(), 0, {std::generic_category().message(errno)}});
}

AppendFile::~AppendFile() {
    ::close(m_descriptor);
}

std::size_t AppendFile::append(std::string_view bytes, std::error_code& error) noexcept {
    error.clear();
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t written = ::write(m_descriptor, bytes.data() + done, bytes.size() - done);
        if (written >= 0) {
            done += static_cast<std::size_t>(written);
        } else if (errno != EINTR) {
            error.assign(errno, std::generic_category());
            break;
        }
    }
    return done;
}

void writeNewFile(const std::filesystem::path& file, std::string_view text) {
    AppendFile out(file);
    std::error_code error;
    out.append(text, error);
    if (!error)
        return;
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    throw InputError(InputFault{InputFault::Kind::NotWritten, file.string(), 0, {error.message()}});
}

} // namespace hexapose
