// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/session.h"

#include "core/record/log_writer.h"

#include <QThread>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <mutex>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace hexapose {

namespace {

constexpr std::chrono::seconds kKept{30}; ///< snapshots kept for a screen that does not ask

/// What the loop solves with: another one from one cycle to the next. Of the loop's thread only.
class ReplaceableSolver final : public ForwardSolver {
public:
    explicit ReplaceableSolver(std::shared_ptr<const ForwardSolver> solver) : m_solver(std::move(solver)) {}
    ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept override {
        return m_solver->solve(lengths, start);
    }
    std::string_view name() const noexcept override { return m_solver->name(); }
    void replace(std::shared_ptr<const ForwardSolver> solver) { m_solver = std::move(solver); }

private:
    std::shared_ptr<const ForwardSolver> m_solver;
};

bool moves(RunState state) {
    return state == RunState::Moving || state == RunState::Settling;
}

} // namespace

struct Session::Impl {
    SessionSetup setup;
    DeviceFactory factory;
    std::unique_ptr<QThread> thread;
    std::unique_ptr<LogWriter> log;
    QString logFile;
    std::atomic<bool> stop{false};

    std::mutex mutex; // guards what follows
    std::deque<Snapshot> pending;
    std::vector<OperatorCommand> early; ///< posted before the loop was there
    ControlLoop* loop = nullptr;
    struct Solver {
        std::shared_ptr<const ForwardSolver> solver;
        std::string modelFingerprint;
    };
    std::optional<Solver> next;                 ///< waits for the loop
    std::shared_ptr<const ForwardSolver> inUse; ///< by the loop

    void run(const ConnectionChoice& choice);
    /// Between two cycles. Nothing when there is no other solver to take, or something moves.
    std::optional<Event> takeSolver(ReplaceableSolver& solver, RunState state);
    void deliver(const Snapshot& snapshot);
    void tellFailure(const std::string& reason, const Snapshot& last);
};

void Session::Impl::deliver(const Snapshot& snapshot) {
    log->append(snapshot);
    const std::lock_guard lock(mutex);
    pending.push_back(snapshot);
    while (snapshot.time - pending.front().time > kKept)
        pending.pop_front();
}

std::optional<Event> Session::Impl::takeSolver(ReplaceableSolver& solver, RunState state) {
    const std::lock_guard lock(mutex);
    if (!next || moves(state))
        return std::nullopt;
    solver.replace(next->solver);
    inUse = next->solver;
    Event event{EventCode::SolverChanged, SolverChoice{std::string(inUse->name()), next->modelFingerprint}};
    next.reset();
    return event;
}

/// The loop is over: a last snapshot says so, with nothing in it that could be taken for live data.
void Session::Impl::tellFailure(const std::string& reason, const Snapshot& last) {
    Snapshot snapshot;
    snapshot.time = last.time;
    snapshot.wallTime = std::chrono::system_clock::now();
    snapshot.cycle = last.cycle + 1;
    snapshot.state = RunState::Fault;
    snapshot.link = LinkState::Lost;
    snapshot.counters = last.counters;
    snapshot.events.push_back({EventCode::LoopFailed, DeviceText{reason}});
    deliver(snapshot);
}

namespace {

/// A busy desktop must not starve the loop until the controller's watchdog stops the platform. Where the
/// system does not allow it, it stays as it was.
void preferThisThread() {
    constexpr int kNice = -10;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
}

} // namespace

void Session::Impl::run(const ConnectionChoice& choice) {
    preferThisThread();
    Snapshot last;
    std::optional<Event> change; // of the solver, told with the cycle that is the first to use it
    try {
        const std::unique_ptr<PlatformDevice> device = factory(choice);
        ReplaceableSolver solver([this] {
            const std::lock_guard lock(mutex);
            return inUse;
        }());
        ControlLoop control(*device, setup.geometry, solver, setup.control, [&](const Snapshot& snapshot) {
            last = snapshot;
            if (change)
                last.events.insert(last.events.begin(), *std::exchange(change, std::nullopt));
            deliver(last);
        });
        {
            const std::lock_guard lock(mutex);
            loop = &control;
            for (const OperatorCommand& command : early)
                control.post(command);
            early.clear();
        }
        std::exception_ptr failure;
        try {
            while (!stop) {
                change = takeSolver(solver, last.state);
                control.cycle();
            }
        } catch (...) {
            failure = std::current_exception();
        }
        {
            const std::lock_guard lock(mutex);
            loop = nullptr;
        }
        control.shutDown(); // also after a failure: first of all the platform stops
        if (failure)
            std::rethrow_exception(failure);
    } catch (const std::exception& error) {
        tellFailure(error.what(), last);
    }
}

Session::Session(SessionSetup setup, DeviceFactory factory, QObject* parent)
    : QObject(parent), m_impl(std::make_unique<Impl>()) {
    m_impl->setup = std::move(setup);
    m_impl->inUse = m_impl->setup.solver;
    m_impl->factory = std::move(factory);
}

Session::~Session() {
    blockSignals(true);
    close();
}

const SessionSetup& Session::setup() const {
    return m_impl->setup;
}

void Session::setSolver(std::shared_ptr<const ForwardSolver> solver, const std::string& modelFingerprint) {
    m_impl->setup.solver = solver;
    m_impl->setup.modelFingerprint = modelFingerprint;
    const std::lock_guard lock(m_impl->mutex);
    if (m_impl->thread)
        m_impl->next = Impl::Solver{std::move(solver), modelFingerprint};
    else
        m_impl->inUse = std::move(solver);
}

std::shared_ptr<const ForwardSolver> Session::solver() const {
    const std::lock_guard lock(m_impl->mutex);
    return m_impl->inUse;
}

void Session::open(const ConnectionChoice& choice) {
    close();
    LogMetadata metadata;
    metadata.platform = m_impl->setup.geometry;
    metadata.modelFingerprint = m_impl->setup.modelFingerprint;
    metadata.solver = std::string(m_impl->setup.solver->name());
    metadata.programVersion = m_impl->setup.programVersion;
    metadata.port = choice.virtualPlatform ? "virtual" : choice.port.toStdString();
    const std::filesystem::path file =
        newLogFile(m_impl->setup.logDirectory, std::chrono::system_clock::now());
    m_impl->log = std::make_unique<LogWriter>(file, metadata);
    m_impl->logFile = QString::fromStdString(file.string());
    m_impl->stop = false;
    {
        const std::lock_guard lock(m_impl->mutex);
        m_impl->pending.clear();
        m_impl->early.clear();
    }
    // A QThread rather than a std::thread: the serial port's notifiers need its event dispatcher.
    m_impl->thread.reset(QThread::create([impl = m_impl.get(), choice] { impl->run(choice); }));
    m_impl->thread->setObjectName(QStringLiteral("control loop"));
    m_impl->thread->start(QThread::HighestPriority);
    emit opened();
}

void Session::close() {
    if (!m_impl->thread)
        return;
    m_impl->stop = true;
    m_impl->thread->wait();
    m_impl->thread.reset();
    m_impl->log.reset();
    {
        const std::lock_guard lock(m_impl->mutex);
        m_impl->next.reset();
        m_impl->inUse = m_impl->setup.solver; // what waited is what the next connection begins with
    }
    emit closed();
}

bool Session::isOpen() const {
    return m_impl->thread != nullptr;
}

void Session::post(const OperatorCommand& command) {
    const std::lock_guard lock(m_impl->mutex);
    if (m_impl->loop)
        m_impl->loop->post(command);
    else if (m_impl->thread)
        m_impl->early.push_back(command);
}

std::vector<Snapshot> Session::takeSnapshots() {
    const std::lock_guard lock(m_impl->mutex);
    std::vector<Snapshot> taken(std::make_move_iterator(m_impl->pending.begin()),
                                std::make_move_iterator(m_impl->pending.end()));
    m_impl->pending.clear();
    return taken;
}

QString Session::logFile() const {
    return m_impl->logFile;
}

std::optional<std::string> Session::logFailure() const {
    return m_impl->log ? m_impl->log->failure() : std::nullopt;
}

} // namespace hexapose
