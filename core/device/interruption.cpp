// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/interruption.h"

#include <poll.h>
#include <sys/eventfd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>

namespace hexapose {

namespace {

bool isReadable(int descriptor, std::chrono::milliseconds wait) {
    pollfd event{descriptor, POLLIN, 0};
    return ::poll(&event, 1, static_cast<int>(wait.count())) > 0;
}

} // namespace

Interruption::Interruption() : m_event(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (m_event.get() < 0)
        throw std::system_error(errno, std::generic_category(), "eventfd");
}

void Interruption::request() {
    ::eventfd_write(m_event.get(), 1);
}

bool Interruption::take() {
    eventfd_t requests = 0;
    return ::eventfd_read(m_event.get(), &requests) == 0;
}

bool Interruption::requested() const {
    return isReadable(m_event.get(), std::chrono::milliseconds(0));
}

void Interruption::wait(std::chrono::milliseconds longest) {
    isReadable(m_event.get(), longest);
    take();
}

} // namespace hexapose
