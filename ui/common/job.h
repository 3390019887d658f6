// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

class QObject;
class QThread;

namespace hexapose {

/// Work on a thread of its own, one at a time; what comes of it is delivered on the thread that owns this
/// object, by the event loop. Nothing is delivered late: not after the object is gone, nor of work that was
/// replaced.
class Job final {
public:
    /// What a piece of work came to: its result, or the message of the exception that ended it.
    template <typename Result>
    struct Outcome {
        std::optional<Result> result;
        QString error;
    };

    explicit Job(QString threadName);
    ~Job(); ///< cancels, and waits for the work to end
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    /// work: called over there, Result work(const Job&). done: called here, done(Outcome<Result>). What runs
    /// already is cancelled and waited for.
    template <typename Work, typename Done>
    void start(Work work, Done done) {
        using Result = std::invoke_result_t<Work, const Job&>;
        run([this, work = std::move(work), done = std::move(done)]() mutable {
            auto outcome = std::make_shared<Outcome<Result>>();
            try {
                outcome->result = work(std::as_const(*this));
            } catch (const std::exception& error) {
                outcome->error = QString::fromUtf8(error.what());
            }
            deliver([this, outcome, done = std::move(done)]() mutable {
                m_running = false;
                done(std::move(*outcome));
            });
        });
    }
    bool isRunning() const { return m_running; }

    void cancel() { m_cancelled = true; }
    // For the work, over there.
    bool isCancelled() const { return m_cancelled; }
    /// Calls something on the owner's thread.
    void deliver(std::function<void()> what) const;

private:
    void run(std::function<void()> work);
    void finish();

    QString m_threadName;
    std::atomic<bool> m_cancelled{false};
    bool m_running = false;              ///< the outcome is still to be delivered
    int m_run = 0;                       ///< counts the works: deliveries of an earlier one are dropped
    std::unique_ptr<QObject> m_receiver; ///< on the owner's thread
    std::unique_ptr<QThread> m_thread;
};

} // namespace hexapose
