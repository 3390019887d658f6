// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/text_source.h"

#include "core/base/input_error.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace hexapose {

namespace {

constexpr int kAskEveryMs = 50;
constexpr std::size_t kBuffer = std::size_t{1} << 18;

std::string reason(int error) {
    return std::generic_category().message(error);
}

/// The bytes of a file, or of a pipe.
class ByteFile {
public:
    ByteFile(const std::filesystem::path& file, std::function<bool()> isCancelled)
        : name(file == "-" ? "standard input" : file.string()), m_isCancelled(std::move(isCancelled)) {
        // Without waiting: a FIFO that nobody writes to would hold us up here for ever.
        m_descriptor =
            file == "-" ? ::dup(STDIN_FILENO) : ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        if (m_descriptor < 0)
            throw InputError(name, "cannot be read: " + reason(errno));
        struct stat status {};
        ::fstat(m_descriptor, &status);
        std::string fault;
        if (S_ISDIR(status.st_mode))
            fault = "is a directory";
        else if (S_ISBLK(status.st_mode) || (S_ISCHR(status.st_mode) && file != "-"))
            fault = "is a device, not a file";
        if (!fault.empty()) {
            ::close(m_descriptor);
            throw InputError(name, fault);
        }
        m_isRegular = S_ISREG(status.st_mode);
        if (m_isRegular && file == "-")
            m_offset = std::max<off_t>(::lseek(m_descriptor, 0, SEEK_CUR), 0);
        size = m_isRegular ? static_cast<std::uint64_t>(status.st_size) : 0;
    }
    ~ByteFile() { ::close(m_descriptor); }
    ByteFile(const ByteFile&) = delete;
    ByteFile& operator=(const ByteFile&) = delete;

    std::size_t read(char* buffer, std::size_t room) {
        for (;;) {
            const ssize_t count = m_isRegular ? ::pread(m_descriptor, buffer, room, m_offset)
                                              : ::read(m_descriptor, buffer, room);
            if (count >= 0) {
                m_offset += count;
                hasShrunk = count == 0 && m_isRegular && static_cast<std::uint64_t>(m_offset) < size;
                return static_cast<std::size_t>(count);
            }
            if (errno == EAGAIN) {
                pollfd event{m_descriptor, POLLIN, 0};
                while (::poll(&event, 1, kAskEveryMs) == 0)
                    if (m_isCancelled && m_isCancelled())
                        return 0;
            } else if (errno != EINTR) {
                throw InputError(name, "cannot be read further: " + reason(errno));
            }
        }
    }
    std::uint64_t offset() const { return static_cast<std::uint64_t>(m_offset); }

    std::string name;
    std::uint64_t size = 0;
    bool hasShrunk = false;

private:
    std::function<bool()> m_isCancelled;
    int m_descriptor = -1;
    bool m_isRegular = false;
    off_t m_offset = 0;
};

/// gzip, several members one after another included.
class Inflater {
public:
    explicit Inflater(ByteFile& file) : m_file(file) {
        if (::inflateInit2(&m_stream, 15 + 16) != Z_OK)
            throw InputError(file.name, "cannot be decompressed: out of memory");
    }
    ~Inflater() { ::inflateEnd(&m_stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    void feed(const char* bytes, std::size_t count) {
        std::memcpy(m_input.data(), bytes, count);
        m_stream.next_in = reinterpret_cast<Bytef*>(m_input.data());
        m_stream.avail_in = static_cast<uInt>(count);
    }
    std::size_t read(char* buffer, std::size_t room) {
        m_stream.next_out = reinterpret_cast<Bytef*>(buffer);
        m_stream.avail_out = static_cast<uInt>(std::min<std::size_t>(room, 1U << 30));
        const uInt asked = m_stream.avail_out;
        while (m_stream.avail_out == asked) {
            if (m_stream.avail_in == 0) {
                feedFromFile();
                if (m_stream.avail_in == 0) { // a file that was cut: what came out stays
                    isCut = isCut || !m_atEnd;
                    return 0;
                }
            }
            if (m_atEnd && ::inflateReset(&m_stream) != Z_OK)
                return 0;
            m_atEnd = false;
            const int result = ::inflate(&m_stream, Z_NO_FLUSH);
            if (result == Z_STREAM_END)
                m_atEnd = true;
            else if (result != Z_OK && result != Z_BUF_ERROR)
                throw InputError(m_file.name, "is damaged: gzip cannot be decompressed further");
        }
        return asked - m_stream.avail_out;
    }
    bool isCut = false;

private:
    void feedFromFile() {
        m_stream.next_in = reinterpret_cast<Bytef*>(m_input.data());
        m_stream.avail_in = static_cast<uInt>(m_file.read(m_input.data(), m_input.size()));
    }
    ByteFile& m_file;
    z_stream m_stream{};
    bool m_atEnd = false;
    std::vector<char> m_input = std::vector<char>(kBuffer);
};

void appendUtf8(std::string& out, std::uint32_t point) {
    if (point < 0x80) {
        out += static_cast<char>(point);
    } else if (point < 0x800) {
        out += static_cast<char>(0xC0 | (point >> 6));
        out += static_cast<char>(0x80 | (point & 0x3F));
    } else if (point < 0x10000) {
        out += static_cast<char>(0xE0 | (point >> 12));
        out += static_cast<char>(0x80 | ((point >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (point & 0x3F));
    } else {
        out += static_cast<char>(0xF0 | (point >> 18));
        out += static_cast<char>(0x80 | ((point >> 12) & 0x3F));
        out += static_cast<char>(0x80 | ((point >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (point & 0x3F));
    }
}

/// UTF-16 of either byte order, piece by piece.
class Utf16Decoder {
public:
    explicit Utf16Decoder(bool bigEndian) : m_bigEndian(bigEndian) {}
    void decode(const char* bytes, std::size_t count, std::string& out) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto byte = static_cast<unsigned char>(bytes[i]);
            if (!m_half) {
                m_half = byte;
                continue;
            }
            const std::uint32_t unit =
                m_bigEndian ? (std::uint32_t{*m_half} << 8 | byte) : (std::uint32_t{byte} << 8 | *m_half);
            m_half.reset();
            take(unit, out);
        }
    }

private:
    void take(std::uint32_t unit, std::string& out) {
        constexpr std::uint32_t kReplacement = 0xFFFD;
        const bool isLow = unit >= 0xDC00 && unit < 0xE000;
        if (m_high && isLow) {
            appendUtf8(out, 0x10000 + ((*m_high - 0xD800) << 10) + (unit - 0xDC00));
            m_high.reset();
            return;
        }
        if (m_high)
            appendUtf8(out, kReplacement);
        m_high.reset();
        if (unit >= 0xD800 && unit < 0xDC00)
            m_high = unit;
        else
            appendUtf8(out, isLow ? kReplacement : unit);
    }
    bool m_bigEndian;
    std::optional<unsigned char> m_half;
    std::optional<std::uint32_t> m_high;
};

} // namespace

struct TextSource::Impl {
    Impl(const std::filesystem::path& file, std::function<bool()> isCancelled)
        : bytes(file, std::move(isCancelled)) {
        begin();
    }

    /// What the first bytes are decides how the rest is read.
    void begin() {
        std::array<char, 4> start{};
        std::size_t count = fill(start);
        if (count >= 2 && start[0] == '\x1F' && start[1] == '\x8B') {
            inflater = std::make_unique<Inflater>(bytes);
            inflater->feed(start.data(), count);
            count = fill(start);
        }
        std::size_t mark = 0;
        if (count >= 3 && start[0] == '\xEF' && start[1] == '\xBB' && start[2] == '\xBF') {
            mark = 3;
        } else if (count >= 2 && ((start[0] == '\xFF' && start[1] == '\xFE') ||
                                  (start[0] == '\xFE' && start[1] == '\xFF'))) {
            decoder.emplace(start[0] == '\xFE');
            mark = 2;
        }
        textBegin = mark;
        if (decoder)
            decoder->decode(start.data() + mark, count - mark, waiting);
        else
            waiting.assign(start.data() + mark, count - mark);
    }
    std::size_t fill(std::array<char, 4>& start) {
        std::size_t count = 0;
        while (count < start.size()) {
            const std::size_t more = readBytes(start.data() + count, start.size() - count);
            if (more == 0)
                break;
            count += more;
        }
        return count;
    }
    std::size_t readBytes(char* buffer, std::size_t room) {
        return inflater ? inflater->read(buffer, room) : bytes.read(buffer, room);
    }

    ByteFile bytes;
    std::unique_ptr<Inflater> inflater;
    std::optional<Utf16Decoder> decoder;
    std::string waiting; ///< decoded, for the next read
    std::size_t taken = 0;
    std::vector<char> raw;
    std::uint64_t textBegin = 0;
};

TextSource::TextSource(const std::filesystem::path& file, std::function<bool()> isCancelled)
    : m_impl(std::make_unique<Impl>(file, std::move(isCancelled))) {}
TextSource::~TextSource() = default;

std::size_t TextSource::read(std::span<char> buffer) {
    Impl& impl = *m_impl;
    while (impl.taken == impl.waiting.size()) {
        if (!impl.decoder)
            return impl.readBytes(buffer.data(), buffer.size());
        impl.raw.resize(kBuffer);
        const std::size_t count = impl.readBytes(impl.raw.data(), impl.raw.size());
        if (count == 0)
            return 0;
        impl.waiting.clear();
        impl.taken = 0;
        impl.decoder->decode(impl.raw.data(), count, impl.waiting);
    }
    const std::size_t count = std::min(buffer.size(), impl.waiting.size() - impl.taken);
    std::memcpy(buffer.data(), impl.waiting.data() + impl.taken, count);
    impl.taken += count;
    return count;
}

const std::string& TextSource::name() const {
    return m_impl->bytes.name;
}
bool TextSource::isPlain() const {
    return !m_impl->inflater && !m_impl->decoder;
}
std::uint64_t TextSource::textBegin() const {
    return m_impl->textBegin;
}
std::uint64_t TextSource::bytesRead() const {
    return m_impl->bytes.offset();
}
std::uint64_t TextSource::size() const {
    return m_impl->bytes.size;
}
bool TextSource::hasShrunk() const {
    return m_impl->bytes.hasShrunk || (m_impl->inflater && m_impl->inflater->isCut);
}

} // namespace hexapose
