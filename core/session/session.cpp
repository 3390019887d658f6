// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/session.h"

#include "core/device/platform_device.h"
#include "core/record/log_writer.h"
#include "core/session/replaceable_solver.h"

#include <pthread.h>

#include <chrono>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace hexapose {

struct Session::Impl {
    SessionSetup setup;
    DeviceFactory factory;
    std::unique_ptr<LogWriter> log;
    std::optional<LogFailure> lastLogFailure; ///< of the log that is complete
    std::shared_ptr<SnapshotRing> ring = std::make_shared<SnapshotRing>();

    mutable std::mutex mutex; // guards what follows
    SessionInfo info;
    bool isOpen = false;
    std::vector<OperatorCommand> early; ///< posted before the loop was there
    ControlLoop* loop = nullptr;
    struct Solver {
        std::shared_ptr<const ForwardSolver> solver;
        std::string modelFingerprint;
    };
    std::optional<Solver> next;                 ///< waits for the loop
    std::shared_ptr<const ForwardSolver> inUse; ///< by the loop

    std::jthread thread;

    void run(const std::stop_token& stop, const ConnectionSpec& connection);
    void claimTheProcessor();
    void cycles(const std::stop_token& stop, const ConnectionSpec& connection, SnapshotPtr& last);
    void setLoop(ControlLoop* control);
    /// Between two cycles. Nothing when there is no other solver to take, or something moves.
    std::optional<Event> takeSolver(ReplaceableSolver& solver, RunState state);
    void deliver(SnapshotPtr snapshot);
    void reportFailure(const std::string& reason, const Snapshot& last);
};

void Session::Impl::deliver(SnapshotPtr snapshot) {
    log->append(snapshot);
    ring->publish(std::move(snapshot));
}

std::optional<Event> Session::Impl::takeSolver(ReplaceableSolver& solver, RunState state) {
    const std::lock_guard lock(mutex);
    if (!next || isInMotion(state))
        return std::nullopt;
    solver.replace(next->solver);
    inUse = next->solver;
    Event event{EventCode::SolverChanged, SolverChoice{std::string(inUse->name()), next->modelFingerprint}};
    next.reset();
    return event;
}

/// The loop is over: a last snapshot says so, with nothing in it that could be taken for live data.
void Session::Impl::reportFailure(const std::string& reason, const Snapshot& last) {
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->time = last.time;
    snapshot->wallTime = std::chrono::system_clock::now();
    snapshot->cycle = last.cycle + 1;
    snapshot->state = RunState::Fault;
    snapshot->link = LinkState::Lost;
    snapshot->counters = last.counters;
    snapshot->events.push_back({EventCode::LoopFailed, DeviceText{reason}});
    deliver(std::move(snapshot));
}

/// A busy desktop must not starve the loop until the controller's watchdog stops the platform.
void Session::Impl::claimTheProcessor() {
    pthread_setname_np(pthread_self(), "control loop");
    const ThreadPriority priority = raiseThreadPriority();
    const bool memoryLocked = lockMemory();
    const std::lock_guard lock(mutex);
    info.priority = priority;
    info.memoryLocked = memoryLocked;
}

void Session::Impl::setLoop(ControlLoop* control) {
    const std::lock_guard lock(mutex);
    loop = control;
    if (loop == nullptr)
        return;
    for (const OperatorCommand& command : early)
        loop->post(command);
    early.clear();
}

void Session::Impl::cycles(const std::stop_token& stop, const ConnectionSpec& connection, SnapshotPtr& last) {
    const std::unique_ptr<PlatformDevice> device = factory(connection);
    ReplaceableSolver solver([this] {
        const std::lock_guard lock(mutex);
        return inUse;
    }());
    std::optional<Event> change; // of the solver, reported with the cycle that is the first to use it
    ControlLoop control(*device, setup.model, solver, setup.control, [&](const Snapshot& snapshot) {
        auto kept = std::make_shared<Snapshot>(snapshot);
        if (change)
            kept->events.insert(kept->events.begin(), *std::exchange(change, std::nullopt));
        log->takeEvents(kept->events);
        last = kept;
        deliver(std::move(kept));
    });
    setLoop(&control);
    std::exception_ptr failure;
    try {
        while (!stop.stop_requested()) {
            change = takeSolver(solver, last->state);
            control.cycle();
        }
    } catch (...) {
        failure = std::current_exception();
    }
    setLoop(nullptr);
    control.shutDown(); // also after a failure: first of all the platform stops
    if (failure)
        std::rethrow_exception(failure);
}

void Session::Impl::run(const std::stop_token& stop, const ConnectionSpec& connection) {
    claimTheProcessor();
    SnapshotPtr last = std::make_shared<Snapshot>();
    try {
        cycles(stop, connection, last);
    } catch (const std::exception& error) {
        reportFailure(error.what(), *last);
    }
}

Session::Session(SessionSetup setup, DeviceFactory factory) : m_impl(std::make_unique<Impl>()) {
    m_impl->setup = std::move(setup);
    m_impl->inUse = m_impl->setup.solver;
    m_impl->factory = std::move(factory);
}

Session::~Session() {
    close();
}

const SessionSetup& Session::setup() const {
    return m_impl->setup;
}

void Session::setSolver(std::shared_ptr<const ForwardSolver> solver, const std::string& modelFingerprint) {
    m_impl->setup.solver = solver;
    m_impl->setup.modelFingerprint = modelFingerprint;
    const std::lock_guard lock(m_impl->mutex);
    if (m_impl->isOpen)
        m_impl->next = Impl::Solver{std::move(solver), modelFingerprint};
    else
        m_impl->inUse = std::move(solver);
}

std::shared_ptr<const ForwardSolver> Session::solver() const {
    const std::lock_guard lock(m_impl->mutex);
    return m_impl->inUse;
}

void Session::open(const ConnectionSpec& connection) {
    close();
    open(connection, newLogFile(m_impl->setup.logDirectory, std::chrono::system_clock::now()));
}

void Session::open(const ConnectionSpec& connection, const std::filesystem::path& logFile) {
    close();
    LogMetadata metadata;
    metadata.platform = m_impl->setup.model->geometry();
    metadata.modelFingerprint = m_impl->setup.modelFingerprint;
    metadata.solver = std::string(m_impl->setup.solver->name());
    metadata.programVersion = m_impl->setup.programVersion;
    metadata.port = nameOf(connection);
    m_impl->log = std::make_unique<LogWriter>(logFile, metadata, m_impl->setup.log);
    m_impl->ring->clear();
    {
        const std::lock_guard lock(m_impl->mutex);
        m_impl->info = SessionInfo{logFile, std::nullopt, false};
        m_impl->early.clear();
        m_impl->isOpen = true;
    }
    m_impl->thread = std::jthread(
        [impl = m_impl.get(), connection](const std::stop_token& stop) { impl->run(stop, connection); });
}

void Session::close() {
    if (!m_impl->thread.joinable())
        return;
    m_impl->thread.request_stop();
    m_impl->thread.join();
    m_impl->log->finish();
    m_impl->lastLogFailure = m_impl->log->failure();
    m_impl->log.reset();
    const std::lock_guard lock(m_impl->mutex);
    m_impl->isOpen = false;
    m_impl->next.reset();
    m_impl->inUse = m_impl->setup.solver; // what waited is what the next connection begins with
}

bool Session::isOpen() const {
    const std::lock_guard lock(m_impl->mutex);
    return m_impl->isOpen;
}

void Session::post(const OperatorCommand& command) {
    const std::lock_guard lock(m_impl->mutex);
    if (m_impl->loop)
        m_impl->loop->post(command);
    else if (m_impl->isOpen)
        m_impl->early.push_back(command);
}

SnapshotReader Session::reader() const {
    return SnapshotReader(m_impl->ring);
}

SessionInfo Session::info() const {
    const std::lock_guard lock(m_impl->mutex);
    return m_impl->info;
}

std::filesystem::path Session::logFile() const {
    return info().logFile;
}

std::optional<LogFailure> Session::logFailure() const {
    return m_impl->log ? m_impl->log->failure() : m_impl->lastLogFailure;
}

} // namespace hexapose
