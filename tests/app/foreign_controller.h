// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/bad_frames.h"
#include "tests/app/foreign_wire.h"
#include "tests/app/machine.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace hexapose::apptest {

/// A controller that nobody of this project wrote, so to say: six legs of constant speed, its own habits
/// where the protocol leaves them open, and one misdeed if asked. Runs in a thread on a pseudo-terminal of
/// its own.
class ForeignController {
public:
    using Clock = std::chrono::steady_clock;
    using Ms = std::chrono::milliseconds;

    struct Traits {
        std::string name = "Rig of another make";
        char bootState = 'U';
        Six homeMm = laboratory().lengths({});
        double awayMm = 6.0; ///< how far the legs are from home when it boots in state U
        double minMm = 250.0;
        double maxMm = 350.0;
        double speedMmPerS = 60.0;
        int decimals = 2;
        Ms period{20};
        bool obeysPeriod = false;
        Ms watchdog{2000}; ///< longer than the protocol's, for busy machines; see typicalGap()
        Ms answerDelay{6};
        Ms homing{1000};
        int hellosNeeded = 2;
        std::string helloAnswer;     ///< in place of the IDENT
        bool reportsUnasked = false; ///< LEN from the start, not only after HELLO
        bool carriageReturn = true;
        bool listenOnly = false; ///< bare lines of lengths; answers nothing
    };
    enum class Misdeed { None, Silence, RefuseSets, Fault, Stop, Restart, Unplug };
    struct Plan {
        Misdeed misdeed = Misdeed::None;
        Ms length{3000};    ///< of a silence, or until it is plugged in again
        double afterMm = 4; ///< once a leg has moved so far by set-points
        int badEvery = 0;   ///< bad bytes before every so many-th LEN; 0: never
    };
    struct Received {
        Clock::time_point time;
        std::string payload;
    };

    ForeignController(const std::string& link, const Traits& traits, const Plan& plan);
    ~ForeignController();

    /// Waits until `condition` holds; false after the patience of the tests. The condition may look at
    /// everything.
    bool waitFor(const std::function<bool()>& condition);
    // What it saw and did; call within waitFor or when the host is gone.
    std::vector<std::string> payloads(const std::string& type = {}) const;
    std::vector<std::string> violations() const;
    std::vector<LenFrame> reports() const; ///< good LEN frames that went out
    int badSent() const;
    int watchdogTrips() const;
    bool misdeedDone() const;
    char state() const;
    int boots() const;
    /// Median time between two frames of the host while enabled.
    Ms typicalGap() const;
    /// Its own thread did not run for so long that it owes the host reports: a failed run says nothing then.
    bool starved() const;
    Six legs() const;

private:
    using Lock = std::unique_lock<std::recursive_mutex>;

    void run(const std::stop_token& stop);
    Clock::time_point nextDue() const;
    void plugIn();
    void unplug();
    void boot();
    void readPort();
    void take(const ForeignReader::Item& item);
    void takeCommand(const std::vector<std::string>& fields);
    bool obey(const std::string& type);
    void takeSet(const std::vector<std::string>& fields);
    void checkSet(const Six& lengths, long number);
    void violate(const std::string& what) { m_violations.push_back(what); }
    void answer(const std::string& payload);
    void reply(const std::string& type, bool allowed);
    void advance(Clock::time_point now);
    void moveLegs(double seconds);
    void misbehave();
    void report();
    void send(const std::string& bytes);
    void flush();

    const Traits m_traits;
    const Plan m_plan;
    const std::string m_link;
    const Clock::time_point m_start = Clock::now();

    mutable std::recursive_mutex m_mutex;
    std::condition_variable_any m_changed;
    int m_master = -1;
    int m_slave = -1;
    int m_wake = -1;
    ForeignReader m_reader;
    std::string m_unsent;
    std::deque<std::pair<Clock::time_point, std::string>> m_answers;

    Clock::time_point m_now = m_start;
    Clock::time_point m_bootTime = m_start;
    Clock::time_point m_lastHeard = m_start;
    Clock::time_point m_nextReport = m_start;
    Clock::time_point m_silentUntil = m_start;
    std::optional<Clock::time_point> m_homedAt;
    std::optional<Clock::time_point> m_plugAt;
    char m_state = 'U';
    Six m_legs{};
    Six m_goals{};
    std::optional<Six> m_firstSet;
    Six m_lastSet{};
    LenFrame m_lastReport;
    Ms m_period{20};
    int m_hellos = 0;
    bool m_identified = false;
    bool m_reporting = false;
    bool m_refusing = false;
    bool m_misdeedDone = false;
    std::uint16_t m_number = 0;
    int m_setNumber = -1;

    // What the host has seen or done, for the judgement of its SETs.
    bool m_enabledReported = false; ///< a LEN with E since the last ENABLE
    bool m_endedByHost = true;      ///< STOP or DISABLE, and no ENABLE since
    int m_setsWhileDown = 0;
    std::optional<long> m_lastHostNumber;

    std::vector<Received> m_received;
    std::vector<std::string> m_violations;
    std::vector<LenFrame> m_reports;
    int m_badSent = 0;
    int m_watchdogTrips = 0;
    int m_boots = 0;
    std::vector<Ms> m_gaps;
    Clock::duration m_longestStep{0};
    std::jthread m_thread;
};

} // namespace hexapose::apptest
