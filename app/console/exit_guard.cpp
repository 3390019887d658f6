// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/exit_guard.h"

#include <cstdlib>
#include <utility>

namespace hexapose {

namespace {

// A handler of std::atexit can reach nothing else.
std::function<void()>& pendingAction() {
    static std::function<void()> action;
    return action;
}

} // namespace

ExitGuard::ExitGuard(std::function<void()> action) {
    pendingAction() = std::move(action);
    std::atexit([] {
        if (const auto pending = std::exchange(pendingAction(), {})) {
            pending();
        }
    });
}

ExitGuard::~ExitGuard() {
    pendingAction() = {};
}

} // namespace hexapose
