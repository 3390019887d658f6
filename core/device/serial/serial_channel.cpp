// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/serial/serial_channel.h"

#include <QDeadlineTimer>
#include <QEventLoop>
#include <QSerialPort>

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>

namespace hexapose {

namespace {

constexpr int kWriteTimeoutMs = 200; ///< a port that takes nothing for so long is as good as gone

/// The device itself: QSerialPort keeps its lock by path, and a symbolic link would get round it.
std::string devicePath(const std::string& path) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path, error);
    if (error)
        throw ChannelError(error == std::errc::no_such_file_or_directory
                               ? PortFailure{PortFailure::Kind::NotFound, path, {}}
                               : PortFailure{PortFailure::Kind::Other, path, error.message()});
    if (!std::filesystem::is_character_file(real, error))
        throw ChannelError(PortFailure{PortFailure::Kind::NotAPort, path, {}});
    if (::access(real.c_str(), R_OK | W_OK) != 0 && errno == EACCES)
        throw ChannelError(PortFailure{PortFailure::Kind::NoPermission, path, {}});
    return real.string();
}

} // namespace

struct SerialChannel::Impl {
    std::string path;
    QEventLoop dispatcher; ///< gives a thread that Qt did not start the dispatcher QSerialPort needs
    QSerialPort port;

    void open(int baud);
    void discardOld();
    [[noreturn]] void fail(PortFailure::Kind kind, const std::string& system = {});
    void checkOpen();
};

void SerialChannel::Impl::fail(PortFailure::Kind kind, const std::string& system) {
    if (port.isOpen())
        port.close();
    throw ChannelError(PortFailure{kind, path, system});
}

void SerialChannel::Impl::open(int baud) {
    port.setPortName(QString::fromStdString(devicePath(path)));
    port.setBaudRate(baud);
    port.setDataBits(QSerialPort::Data8);
    port.setParity(QSerialPort::NoParity);
    port.setStopBits(QSerialPort::OneStop);
    port.setFlowControl(QSerialPort::NoFlowControl);
    if (!port.open(QIODevice::ReadWrite)) {
        const std::string reason = port.errorString().toStdString();
        if (port.error() == QSerialPort::PermissionError)
            fail(PortFailure::Kind::Busy, reason);
        fail(PortFailure::Kind::NotOpened, reason);
    }
    discardOld();
}

/// What came before this connection is old. A pseudo-terminal keeps more of it than one clear() reaches.
void SerialChannel::Impl::discardOld() {
    constexpr int kLongestMs = 50;
    constexpr int kPauseMs = 1;
    port.clear();
    for (QDeadlineTimer deadline(kLongestMs); !deadline.hasExpired() && port.waitForReadyRead(kPauseMs);)
        port.readAll();
    port.clearError();
}

void SerialChannel::Impl::checkOpen() {
    if (!port.isOpen())
        throw ChannelError(PortFailure{PortFailure::Kind::Closed, path, {}});
    switch (port.error()) {
    case QSerialPort::NoError:
    case QSerialPort::TimeoutError:
        return;
    default:
        fail(PortFailure::Kind::Gone); // the system's word for it is that of whichever call came first
    }
}

SerialChannel::SerialChannel(const std::string& path, int baud) : m_impl(std::make_unique<Impl>()) {
    m_impl->path = path;
    m_impl->open(baud);
}

SerialChannel::~SerialChannel() = default;

/// Straight from the system: QSerialPort's own wait costs several times the processor time and ends for bytes
/// alone.
std::size_t SerialChannel::read(std::span<char> buffer, std::chrono::milliseconds wait,
                                const Interruption& interruption) {
    QSerialPort& port = m_impl->port;
    if (port.bytesAvailable() > 0) // taken in while bytes went out
        return static_cast<std::size_t>(
            std::max<qint64>(port.read(buffer.data(), static_cast<qint64>(buffer.size())), 0));
    m_impl->checkOpen();
    std::array<pollfd, 2> events{
        {{static_cast<int>(port.handle()), POLLIN, 0}, {interruption.descriptor(), POLLIN, 0}}};
    if (::poll(events.data(), events.size(), static_cast<int>(wait.count())) <= 0 || events[0].revents == 0)
        return 0;
    const ssize_t count = ::read(events[0].fd, buffer.data(), buffer.size());
    if (count > 0)
        return static_cast<std::size_t>(count); // bytes that came before the port went are still good
    if (count == 0 ? (events[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0
                   : errno != EAGAIN && errno != EINTR)
        m_impl->fail(PortFailure::Kind::Gone);
    return 0;
}

void SerialChannel::write(std::string_view bytes) {
    QSerialPort& port = m_impl->port;
    m_impl->checkOpen();
    if (port.write(bytes.data(), static_cast<qint64>(bytes.size())) < 0)
        m_impl->checkOpen();
    port.flush();
    for (QDeadlineTimer deadline(kWriteTimeoutMs); port.bytesToWrite() > 0;) {
        if (!port.waitForBytesWritten(static_cast<int>(deadline.remainingTime())) && deadline.hasExpired())
            m_impl->fail(PortFailure::Kind::NotTaking);
        m_impl->checkOpen();
    }
    m_impl->checkOpen();
}

std::size_t SerialChannel::unsent() {
    int queued = 0;
    if (!m_impl->port.isOpen() || ::ioctl(m_impl->port.handle(), TIOCOUTQ, &queued) != 0)
        return 0;
    return static_cast<std::size_t>(std::max(queued, 0));
}

void SerialChannel::dropUnsent() {
    if (m_impl->port.isOpen())
        m_impl->port.clear(QSerialPort::Output);
}

} // namespace hexapose
