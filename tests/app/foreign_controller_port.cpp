// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/foreign_controller.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace hexapose::apptest {

void ForeignController::plugIn() {
    m_master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    std::array<char, 64> name{};
    if (m_master < 0 || ::grantpt(m_master) != 0 || ::unlockpt(m_master) != 0 ||
        ::ptsname_r(m_master, name.data(), name.size()) != 0)
        throw std::runtime_error("no pseudo-terminal");
    ::fcntl(m_master, F_SETFL, O_NONBLOCK);
    m_slave = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings{};
    ::tcgetattr(m_slave, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(m_slave, TCSANOW, &settings);
    const std::string fresh = m_link + ".new";
    ::unlink(fresh.c_str());
    if (::symlink(name.data(), fresh.c_str()) != 0 || std::rename(fresh.c_str(), m_link.c_str()) != 0)
        throw std::runtime_error("no link to the pseudo-terminal");
}

void ForeignController::unplug() {
    for (int* fd : {&m_master, &m_slave}) {
        if (*fd >= 0)
            ::close(*fd);
        *fd = -1;
    }
    m_unsent.clear();
    m_reader = {};
}

void ForeignController::send(const std::string& bytes) {
    const bool silent = m_now < m_silentUntil;
    if (!silent && m_unsent.size() < 4096) // nobody reads: what is new is lost, as on a real line
        m_unsent += bytes;
    flush();
}

void ForeignController::flush() {
    if (m_master < 0)
        return;
    ::ioctl(m_slave, TIOCNXCL); // a host that was killed leaves its claim on the line behind
    const ssize_t count = ::write(m_master, m_unsent.data(), m_unsent.size());
    if (count > 0)
        m_unsent.erase(0, static_cast<std::size_t>(count));
}

void ForeignController::readPort() {
    std::array<char, 4096> buffer;
    const ssize_t count = ::read(m_master, buffer.data(), buffer.size());
    if (count <= 0)
        return;
    for (const ForeignReader::Item& item : m_reader.feed({buffer.data(), static_cast<std::size_t>(count)}))
        take(item);
}

} // namespace hexapose::apptest
