// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/foreign_host.h"

#include "tests/app/process.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace hexapose::apptest {

ForeignHost::ForeignHost(const std::string& port)
    : m_fd(::open(port.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)) {
    if (m_fd < 0)
        throw std::runtime_error("cannot open " + port);
    termios settings{};
    ::tcgetattr(m_fd, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(m_fd, TCSANOW, &settings);
    // What stands in the line from before begins anywhere in a frame.
    ::tcflush(m_fd, TCIFLUSH);
    write("\n");
}

ForeignHost::~ForeignHost() {
    ::close(m_fd);
}

void ForeignHost::write(const std::string& bytes) {
    if (::write(m_fd, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
        ADD_FAILURE() << "the port did not take " << bytes;
}

bool ForeignHost::pump(int milliseconds) {
    pollfd wait{m_fd, POLLIN, 0};
    if (::poll(&wait, 1, milliseconds) <= 0)
        return false;
    std::array<char, 4096> buffer;
    const ssize_t count = ::read(m_fd, buffer.data(), buffer.size());
    if (count <= 0)
        return false;
    for (ForeignReader::Item& item : m_reader.feed({buffer.data(), static_cast<std::size_t>(count)})) {
        if (item.payload) {
            m_payloads.push_back(*item.payload);
        } else {
            ++m_badItems;
            m_badBytes.push_back(item.bytes);
        }
    }
    return true;
}

ForeignHost::Fields ForeignHost::await(const std::function<bool(const Fields&)>& fits,
                                       const std::function<void()>& idle) {
    constexpr auto kIdleEvery = std::chrono::milliseconds(50);
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    auto nextIdle = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() < deadline) {
        while (!m_payloads.empty()) {
            const Fields fields = splitFields(m_payloads.front());
            m_payloads.pop_front();
            if (fits(fields))
                return fields;
        }
        if (idle && std::chrono::steady_clock::now() >= nextIdle) {
            idle();
            nextIdle = std::chrono::steady_clock::now() + kIdleEvery;
        }
        pump(static_cast<int>(kIdleEvery.count()));
    }
    ADD_FAILURE() << "what was waited for did not come";
    return Fields(16);
}

ForeignHost::Fields ForeignHost::awaitType(const std::string& type) {
    return await([&](const Fields& fields) { return fields.front() == type; });
}

ForeignHost::Fields ForeignHost::awaitState(char state) {
    return await([&](const Fields& fields) {
        return fields.front() == "LEN" && fields.size() == 11 && fields[9] == std::string(1, state);
    });
}

std::string ForeignHost::ask(const std::string& payload) {
    send(payload);
    const std::string type = splitFields(payload).front();
    const Fields fields = await([&](const Fields& f) {
        return f.front() == "IDENT" ||
               ((f.front() == "OK" || f.front() == "ERR") && f.size() > 1 && f[1] == type);
    });
    std::string text;
    for (const std::string& field : fields)
        text += (text.empty() ? "" : ",") + field;
    return text;
}

} // namespace hexapose::apptest
