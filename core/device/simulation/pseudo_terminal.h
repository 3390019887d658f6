// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/file_descriptor.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace hexapose {

/// A port made of software: what is written here is read at path(), and the reverse. Hosts may open and close
/// path() as often as they like.
class PseudoTerminal {
public:
    /// link, unless empty, becomes a symbolic link to the port; an existing one is replaced, anything else
    /// there is an InputError. Throws ChannelError when the system has no pseudo-terminal left.
    explicit PseudoTerminal(const std::filesystem::path& link = {});
    ~PseudoTerminal(); ///< removes the link
    PseudoTerminal(const PseudoTerminal&) = delete;
    PseudoTerminal& operator=(const PseudoTerminal&) = delete;

    const std::string& path() const { return m_path; } ///< "/dev/pts/7"
    int pollDescriptor() const { return m_master.get(); }
    /// Bytes from the host that are here; 0 when there are none. Never waits.
    std::size_t read(std::span<char> buffer);
    /// As many bytes as the port takes; never waits for a host that does not read.
    std::size_t write(std::string_view bytes);
    /// Lets the next host in: one that was killed while it had the port for itself leaves it locked.
    void unlock();

private:
    void makeLink(const std::filesystem::path& link);

    FileDescriptor m_master;
    FileDescriptor m_slave; ///< kept open: without it every host that closes the port looks like a hang-up
    std::string m_path;
    std::filesystem::path m_link;
};

} // namespace hexapose
