// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <sys/types.h>

namespace hexapose::apptest {

/// Longest wait for anything that a sound program does at once or in seconds.
inline constexpr std::chrono::seconds kPatience{100};

struct Outcome {
    int status = -1; ///< exit status; 128 + signal when one ended it
    std::string out;
    std::string err;
};

/// One of the programs, running, with HOME and the XDG directories of the tests. Killed when it goes out of
/// scope.
class Process {
public:
    using Environment = std::map<std::string, std::string>;

    explicit Process(const std::vector<std::string>& words, const std::string& input = {},
                     const Environment& environment = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// The next line of standard output; a test failure and "" when none comes.
    std::string readLine();
    void signal(int number);
    pid_t pid() const { return m_pid; }
    /// Until it ends; a test failure when it does not.
    Outcome wait(std::chrono::seconds patience = kPatience);

private:
    using Deadline = std::chrono::steady_clock::time_point;
    bool pump(Deadline deadline);
    void reap();

    pid_t m_pid = -1;
    int m_out = -1;
    int m_err = -1;
    int m_exit = -1; ///< readable when the process has ended
    bool m_ended = false;
    std::size_t m_lineStart = 0;
    Outcome m_outcome;
};

/// Looks again and again; false when it does not come true within the patience of the tests.
bool eventually(const std::function<bool()>& condition);

/// hexapose-cli, from start to end.
Outcome cli(std::vector<std::string> words, const std::string& input = {},
            const Process::Environment& environment = {});
std::vector<std::string> cliWords(std::vector<std::string> words);

/// "" when it is exactly one line with all of these words in it; otherwise what is wrong.
std::string notOneLineWith(const std::string& text, const std::vector<std::string>& parts);

} // namespace hexapose::apptest
