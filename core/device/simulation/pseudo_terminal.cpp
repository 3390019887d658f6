// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/simulation/pseudo_terminal.h"

#include "core/base/input_error.h"
#include "core/device/byte_channel.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace hexapose {

namespace {

[[noreturn]] void fail(const std::string& what) {
    throw ChannelError(what + ": " + std::generic_category().message(errno));
}

FileDescriptor openMaster() {
    FileDescriptor master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
    if (master.get() < 0 || ::grantpt(master.get()) != 0 || ::unlockpt(master.get()) != 0)
        fail("no pseudo-terminal");
    if (::fcntl(master.get(), F_SETFL, O_NONBLOCK) != 0)
        fail("pseudo-terminal");
    return master;
}

/// Bytes pass as they are: no echo, no line editing, no signals.
void makeRaw(int fd) {
    termios settings{};
    if (::tcgetattr(fd, &settings) != 0)
        fail("pseudo-terminal");
    ::cfmakeraw(&settings);
    if (::tcsetattr(fd, TCSANOW, &settings) != 0)
        fail("pseudo-terminal");
}

} // namespace

PseudoTerminal::PseudoTerminal(const std::filesystem::path& link) : m_master(openMaster()) {
    std::array<char, 128> name{};
    if (::ptsname_r(m_master.get(), name.data(), name.size()) != 0)
        fail("pseudo-terminal");
    m_path = name.data();
    m_slave = FileDescriptor(::open(m_path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    if (m_slave.get() < 0)
        fail(m_path);
    makeRaw(m_slave.get());
    if (!link.empty())
        makeLink(link);
}

PseudoTerminal::~PseudoTerminal() {
    std::error_code ignored;
    // Only the link that is still ours: another program may have taken the name meanwhile.
    if (!m_link.empty() && std::filesystem::read_symlink(m_link, ignored) == m_path)
        std::filesystem::remove(m_link, ignored);
}

void PseudoTerminal::makeLink(const std::filesystem::path& link) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::symlink_status(link, error);
    if (std::filesystem::exists(status)) {
        if (!std::filesystem::is_symlink(status))
            throw InputError(link.string(), "exists and is not a symbolic link; it is left alone");
        std::filesystem::remove(link, error);
    }
    std::filesystem::create_symlink(m_path, link, error);
    if (error)
        throw InputError(link.string(), "cannot make the link: " + error.message());
    m_link = link;
}

std::size_t PseudoTerminal::read(std::span<char> buffer) {
    const ssize_t count = ::read(m_master.get(), buffer.data(), buffer.size());
    if (count < 0 && errno != EAGAIN && errno != EINTR)
        fail(m_path);
    return count > 0 ? static_cast<std::size_t>(count) : 0;
}

std::size_t PseudoTerminal::write(std::string_view bytes) {
    const ssize_t count = ::write(m_master.get(), bytes.data(), bytes.size());
    if (count < 0 && errno != EAGAIN && errno != EINTR)
        fail(m_path);
    return count > 0 ? static_cast<std::size_t>(count) : 0;
}

void PseudoTerminal::unlock() {
    ::ioctl(m_slave.get(), TIOCNXCL);
}

} // namespace hexapose
