// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/foreign_wire.h"

#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace hexapose::apptest {

/// A host that is not Hexapose: opens a port and talks.
class ForeignHost {
public:
    explicit ForeignHost(const std::string& port);
    ~ForeignHost();
    ForeignHost(const ForeignHost&) = delete;
    ForeignHost& operator=(const ForeignHost&) = delete;

    void write(const std::string& bytes);
    void send(const std::string& payload) { write(foreignFrame(payload)); }
    /// The first payload from here on that fits, as fields; a test failure when none comes. `idle` is called
    /// about every 50 ms while waiting.
    using Fields = std::vector<std::string>;
    Fields await(const std::function<bool(const Fields&)>& fits, const std::function<void()>& idle = {});
    Fields awaitType(const std::string& type);
    /// The next LEN whose state is this letter.
    Fields awaitState(char state);
    /// Sends, and returns the answer: OK or ERR of the same type, or IDENT, whole.
    std::string ask(const std::string& payload);

    int badItems() const { return m_badItems; } ///< what a strict reader had to drop
    const std::vector<std::string>& badBytes() const { return m_badBytes; }

private:
    bool pump(int milliseconds);

    int m_fd;
    ForeignReader m_reader;
    std::deque<std::string> m_payloads;
    int m_badItems = 0;
    std::vector<std::string> m_badBytes;
};

} // namespace hexapose::apptest
