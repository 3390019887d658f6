// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/interrupt.h"

#include <csignal>

namespace hexapose {

namespace {

// A signal handler can reach nothing else.
volatile std::sig_atomic_t receivedSignal = 0;

} // namespace

void catchInterrupts() {
    const auto remember = [](int number) { receivedSignal = number; };
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
    std::signal(SIGHUP, remember);
}

bool interrupted() {
    return receivedSignal != 0;
}

} // namespace hexapose
