// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/gzip_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <system_error>
#include <vector>

namespace hexapose {

namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 18;
constexpr const char* kMode = "wb6";

class Descriptor {
public:
    Descriptor(const std::filesystem::path& file, int flags)
        : number(::open(file.c_str(), flags | O_CLOEXEC, 0644)) {}
    ~Descriptor() {
        if (number >= 0)
            ::close(number);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    const int number;
};

/// Compresses into the descriptor, which stays open.
bool compress(int from, int to, const std::stop_token& stop) {
    const int own = ::dup(to); // gzclose() closes what it was given
    gzFile out = own < 0 ? nullptr : ::gzdopen(own, kMode);
    if (out == nullptr) {
        if (own >= 0)
            ::close(own);
        return false;
    }
    std::vector<char> buffer(kBuffer);
    bool good = true;
    for (bool atEnd = false; good && !atEnd;) {
        const ssize_t count = ::read(from, buffer.data(), buffer.size());
        if (count < 0) {
            good = errno == EINTR;
            continue;
        }
        atEnd = count == 0;
        const auto size = static_cast<unsigned>(count);
        good = !stop.stop_requested() &&
               (atEnd || ::gzwrite(out, buffer.data(), size) == static_cast<int>(size));
    }
    return ::gzclose(out) == Z_OK && good && ::fsync(to) == 0;
}

} // namespace

bool gzipFile(const std::filesystem::path& from, const std::filesystem::path& to,
              const std::stop_token& stop) {
    const Descriptor in(from, O_RDONLY);
    if (in.number < 0)
        return false;
    const Descriptor out(to, O_WRONLY | O_CREAT | O_EXCL);
    if (out.number < 0)
        return false;
    if (compress(in.number, out.number, stop))
        return true;
    std::error_code ignored;
    std::filesystem::remove(to, ignored);
    return false;
}

} // namespace hexapose
