// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/common/job.h"

#include <functional>
#include <type_traits>
#include <utility>

namespace hexapose {

/// Work of which only the newest counts, such as a check at every key that is typed. What is started replaces
/// what runs, which is cancelled and not waited for; only the outcome of the last start is delivered.
class NewestJob final {
public:
    explicit NewestJob(QString threadName) : m_job(std::move(threadName)) {}

    /// As Job::start(); both can be copied.
    template <typename Work, typename Done>
    void start(Work work, Done done) {
        using Result = std::invoke_result_t<Work, const Job&>;
        m_isRunning = true;
        m_next = [this, work = std::move(work), done = std::move(done), number = ++m_number] {
            m_job.start(work, [this, done, number](const Job::Outcome<Result>& outcome) {
                if (m_next) {
                    startNext();
                } else if (number == m_number) {
                    m_isRunning = false;
                    done(outcome);
                }
            });
        };
        if (m_job.isRunning()) {
            m_job.cancel();
        } else {
            startNext();
        }
    }
    /// Nothing is delivered any more of what was started so far.
    void cancel() {
        ++m_number;
        m_next = nullptr;
        m_isRunning = false;
        m_job.cancel();
    }
    /// An outcome is still to be delivered.
    bool isRunning() const { return m_isRunning; }

private:
    void startNext() { std::exchange(m_next, nullptr)(); }

    std::function<void()> m_next; ///< waits for the one before to end
    int m_number = 0;             ///< of the last start
    bool m_isRunning = false;
    Job m_job; ///< last, so that it is waited for first
};

} // namespace hexapose
