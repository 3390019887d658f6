// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/end_signals.h"

#include <QSocketNotifier>

#include <csignal>
#include <sys/signalfd.h>
#include <unistd.h>

namespace hexapose {

EndSignals::EndSignals() {
    sigset_t awaited;
    sigemptyset(&awaited);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        sigaddset(&awaited, number);
    }
    pthread_sigmask(SIG_BLOCK, &awaited, nullptr);
    std::signal(SIGPIPE, SIG_IGN); // who reads our messages may go; the platform is still to be stopped
    m_descriptor = signalfd(-1, &awaited, SFD_CLOEXEC | SFD_NONBLOCK);
}

EndSignals::~EndSignals() {
    delete m_notifier;
    ::close(m_descriptor);
}

void EndSignals::watch() {
    m_notifier = new QSocketNotifier(m_descriptor, QSocketNotifier::Read, this);
    connect(m_notifier, &QSocketNotifier::activated, this, &EndSignals::take);
}

void EndSignals::take() {
    signalfd_siginfo info{};
    if (::read(m_descriptor, &info, sizeof info) == static_cast<ssize_t>(sizeof info)) {
        emit received(static_cast<int>(info.ssi_signo));
    }
}

} // namespace hexapose

#include "moc_end_signals.cpp"
