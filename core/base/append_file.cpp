// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/append_file.h"

#include "core/base/input_error.h"

#include <cerrno>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hexapose {

AppendFile::AppendFile(const std::filesystem::path& file)
    : m_path(file),
      m_descriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644)) {
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
            m_size += static_cast<std::uint64_t>(written);
        } else if (errno != EINTR) {
            error.assign(errno, std::generic_category());
            break;
        }
    }
    return done;
}

std::size_t AppendFile::read(std::span<char> buffer, std::uint64_t from, std::error_code& error) noexcept {
    error.clear();
    for (;;) {
        const ssize_t count = ::pread(m_descriptor, buffer.data(), buffer.size(), static_cast<off_t>(from));
        if (count >= 0)
            return static_cast<std::size_t>(count);
        if (errno != EINTR) {
            error.assign(errno, std::generic_category());
            return 0;
        }
    }
}

AppendFile::Place AppendFile::place() const noexcept {
    struct stat own {};
    struct stat there {};
    if (::fstat(m_descriptor, &own) != 0)
        return Place::Kept;
    if (own.st_nlink == 0)
        return Place::Deleted;
    if (::stat(m_path.c_str(), &there) != 0) // a path that cannot be asked about says nothing
        return errno == ENOENT || errno == ENOTDIR ? Place::Moved : Place::Kept;
    const bool same = own.st_dev == there.st_dev && own.st_ino == there.st_ino;
    return same && static_cast<std::uint64_t>(own.st_size) >= m_size ? Place::Kept : Place::Moved;
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
