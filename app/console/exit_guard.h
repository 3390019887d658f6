// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace hexapose {

/// A display that goes away makes Qt end the program by exit(), past every destructor. While a guard is
/// there, its action is done first. One at a time.
class ExitGuard {
public:
    explicit ExitGuard(std::function<void()> action);
    ~ExitGuard();
    ExitGuard(const ExitGuard&) = delete;
    ExitGuard& operator=(const ExitGuard&) = delete;
};

} // namespace hexapose
