// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/process.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <stdexcept>
#include <thread>

namespace hexapose::apptest {

namespace {

constexpr int kPipeSize = 1 << 20;

std::array<int, 2> makePipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw std::runtime_error("no pipe");
    return ends;
}

/// The read end of a pipe that holds the whole input already.
int pipeWith(const std::string& input) {
    const auto [reader, writer] = makePipe();
    ::fcntl(writer, F_SETPIPE_SZ, kPipeSize);
    if (::write(writer, input.data(), input.size()) != static_cast<ssize_t>(input.size()))
        throw std::runtime_error("the input of a test is larger than a pipe");
    ::close(writer);
    return reader;
}

std::vector<std::string> environmentWith(const Process::Environment& changes) {
    const std::string home = HEXAPOSE_TEST_HOME;
    Process::Environment all{{"HOME", home},
                             {"XDG_CACHE_HOME", home + "/cache"},
                             {"XDG_DATA_HOME", home + "/data"},
                             {"XDG_CONFIG_HOME", home + "/config"},
                             {"QT_QPA_PLATFORM", "offscreen"}};
    for (const auto& [name, value] : changes)
        all[name] = value;
    std::vector<std::string> lines;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string line = *entry;
        if (!all.contains(line.substr(0, line.find('='))))
            lines.push_back(line);
    }
    for (const auto& [name, value] : all)
        lines.push_back(name + "=" + value);
    return lines;
}

std::vector<char*> pointers(std::vector<std::string>& lines) {
    std::vector<char*> result;
    for (std::string& line : lines)
        result.push_back(line.data());
    result.push_back(nullptr);
    return result;
}

/// False at the end of the stream.
bool readSome(int fd, std::string& text) {
    std::array<char, 65536> buffer;
    const ssize_t count = ::read(fd, buffer.data(), buffer.size());
    if (count > 0)
        text.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

} // namespace

Process::Process(const std::vector<std::string>& words, const std::string& input,
                 const Environment& environment) {
    const int in = pipeWith(input);
    const auto [outReader, outWriter] = makePipe();
    const auto [errReader, errWriter] = makePipe();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, outWriter, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errWriter, STDERR_FILENO);
    std::vector<std::string> arguments = words;
    std::vector<std::string> variables = environmentWith(environment);
    const int failed = ::posix_spawn(&m_pid, words.at(0).c_str(), &actions, nullptr,
                                     pointers(arguments).data(), pointers(variables).data());
    posix_spawn_file_actions_destroy(&actions);
    for (const int fd : {in, outWriter, errWriter})
        ::close(fd);
    if (failed != 0)
        throw std::runtime_error("cannot start " + words.at(0));
    m_out = outReader;
    m_err = errReader;
    m_exit = static_cast<int>(::syscall(SYS_pidfd_open, m_pid, 0));
    for (const int fd : {m_out, m_err})
        ::fcntl(fd, F_SETFL, O_NONBLOCK);
}

Process::~Process() {
    if (!m_ended) {
        ::kill(m_pid, SIGKILL);
        ::waitpid(m_pid, nullptr, 0);
    }
    for (const int fd : {m_out, m_err, m_exit})
        if (fd >= 0)
            ::close(fd);
}

/// Takes what there is, after waiting for some; false when nothing came before the deadline.
bool Process::pump(Deadline deadline) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    std::array<pollfd, 3> waits{{{m_out, POLLIN, 0}, {m_err, POLLIN, 0}, {m_exit, POLLIN, 0}}};
    if (::poll(waits.data(), waits.size(), std::max(0, static_cast<int>(left.count()))) <= 0)
        return false;
    const auto take = [](const pollfd& wait, int& fd, std::string& text) {
        if (wait.revents != 0 && !readSome(fd, text)) {
            ::close(fd);
            fd = -1;
        }
    };
    take(waits[0], m_out, m_outcome.out);
    take(waits[1], m_err, m_outcome.err);
    if (waits[2].revents != 0 && m_out < 0 && m_err < 0)
        reap();
    return true;
}

void Process::reap() {
    int status = 0;
    ::waitpid(m_pid, &status, 0);
    m_outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    m_ended = true;
}

std::string Process::readLine() {
    const Deadline deadline = std::chrono::steady_clock::now() + kPatience;
    for (;;) {
        const std::size_t end = m_outcome.out.find('\n', m_lineStart);
        if (end != std::string::npos) {
            const std::string line = m_outcome.out.substr(m_lineStart, end - m_lineStart);
            m_lineStart = end + 1;
            return line;
        }
        if (m_ended || !pump(deadline)) {
            ADD_FAILURE() << "no line came; standard error: " << m_outcome.err;
            return {};
        }
    }
}

void Process::signal(int number) {
    ::kill(m_pid, number);
}

Outcome Process::wait(std::chrono::seconds patience) {
    const Deadline deadline = std::chrono::steady_clock::now() + patience;
    while (!m_ended) {
        if (pump(deadline))
            continue;
        ADD_FAILURE() << "the program did not end; standard error: " << m_outcome.err;
        ::kill(m_pid, SIGKILL);
        reap();
    }
    return m_outcome;
}

bool eventually(const std::function<bool()>& condition) {
    constexpr std::chrono::milliseconds kLookEvery{20};
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > deadline)
            return false;
        std::this_thread::sleep_for(kLookEvery);
    }
    return true;
}

std::vector<std::string> cliWords(std::vector<std::string> words) {
    words.insert(words.begin(), HEXAPOSE_CLI);
    return words;
}

Outcome cli(std::vector<std::string> words, const std::string& input,
            const Process::Environment& environment) {
    Process process(cliWords(std::move(words)), input, environment);
    return process.wait();
}

std::string notOneLineWith(const std::string& text, const std::vector<std::string>& parts) {
    if (std::count(text.begin(), text.end(), '\n') != 1 || !text.ends_with('\n'))
        return "not one line: " + text;
    for (const std::string& part : parts)
        if (text.find(part) == std::string::npos)
            return "does not say '" + part + "': " + text;
    return {};
}

} // namespace hexapose::apptest
