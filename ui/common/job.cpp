// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/job.h"

#include <QObject>
#include <QThread>

namespace hexapose {

Job::Job(QString threadName) : m_threadName(std::move(threadName)), m_receiver(std::make_unique<QObject>()) {}

Job::~Job() {
    finish();
}

void Job::deliver(std::function<void()> what) const {
    QMetaObject::invokeMethod(
        m_receiver.get(),
        [this, run = m_run, what = std::move(what)] {
            if (run == m_run) {
                what();
            }
        },
        Qt::QueuedConnection);
}

void Job::run(std::function<void()> work) {
    finish();
    m_cancelled = false;
    m_running = true;
    m_thread.reset(QThread::create(std::move(work)));
    m_thread->setObjectName(m_threadName);
    m_thread->start();
}

void Job::finish() {
    if (m_thread) {
        m_cancelled = true;
        m_thread->wait();
        m_thread.reset();
    }
    ++m_run;
    m_running = false;
}

} // namespace hexapose
