// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// What is seen of a controller that is slow, or of a host that stood still, in a time that the test makes.

#include "core/machine/feedback_monitor.h"
#include "core/machine/following_error_monitor.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace std::chrono_literals;

using Time = std::chrono::steady_clock::time_point;

constexpr Time kBegin{1000s};

DeviceFeedback measured(Time at, std::chrono::milliseconds period) {
    DeviceFeedback feedback;
    feedback.lengths = LegLengths::Constant(0.3);
    feedback.receivedAt = at;
    feedback.period = period;
    feedback.echoesSetPoints = true;
    feedback.acceptedSetPoint = 7;
    return feedback;
}

/// The same controller in a cycle without a measurement.
DeviceFeedback silent(DeviceFeedback feedback) {
    feedback.lengths.reset();
    return feedback;
}

TEST(FeedbackMonitor, GivesASlowControllerThreeOfItsPeriods) {
    FeedbackMonitor monitor(200ms);
    const DeviceFeedback slow = measured(kBegin, 150ms);
    monitor.update(slow, kBegin);
    monitor.update(silent(slow), kBegin + 440ms);
    EXPECT_FALSE(monitor.stale()) << "longer than the limit for a quick one, and yet within three periods";
    monitor.update(silent(slow), kBegin + 460ms);
    EXPECT_TRUE(monitor.stale());

    FeedbackMonitor other(200ms);
    const DeviceFeedback quick = measured(kBegin, 10ms);
    other.update(quick, kBegin);
    other.update(silent(quick), kBegin + 190ms);
    EXPECT_FALSE(other.stale());
    other.update(silent(quick), kBegin + 210ms);
    EXPECT_TRUE(other.stale());
}

TEST(FeedbackMonitor, MeasuresTheJitterOfThePeriod) {
    FeedbackMonitor monitor(200ms);
    monitor.update(measured(kBegin, 10ms), kBegin);
    EXPECT_FALSE(monitor.jitter()) << "the first of all";
    monitor.update(measured(kBegin + 13ms, 10ms), kBegin + 13ms);
    EXPECT_EQ(monitor.jitter(), 3ms);
    monitor.update(measured(kBegin + 22ms, 10ms), kBegin + 22ms);
    EXPECT_EQ(monitor.jitter(), -1ms);
    monitor.update(silent(measured(kBegin + 22ms, 10ms)), kBegin + 30ms);
    EXPECT_FALSE(monitor.jitter()) << "no measurement";
    monitor.forget();
    monitor.update(measured(kBegin + 90ms, 10ms), kBegin + 90ms);
    EXPECT_FALSE(monitor.jitter()) << "the port was gone between";
    monitor.update(measured(kBegin + 95ms, 0ms), kBegin + 95ms);
    EXPECT_FALSE(monitor.jitter()) << "the period is not known";
}

class Echo : public ::testing::Test {
protected:
    /// Set-points go out at these times, and the controller measures, and accepts none of them.
    std::optional<Event> afterSending(int count, std::chrono::milliseconds apart) {
        std::optional<Event> event = m_monitor.checkLegs(measured(kBegin, 10ms), m_lengths, kBegin);
        for (int i = 1; i <= count && !event; ++i) {
            const Time now = kBegin + i * apart;
            m_monitor.sent(now);
            event = m_monitor.checkLegs(measured(now, 10ms), m_lengths, now);
        }
        return event;
    }

    const LegLengths m_lengths = LegLengths::Constant(0.3);
    FollowingErrorMonitor m_monitor{0.01, 300ms};
};

TEST_F(Echo, AHostThatStoodStillAccusesNoController) {
    EXPECT_FALSE(afterSending(5, 400ms)) << "2 s in all, but only five set-points";
}

TEST_F(Echo, AControllerThatAcceptsNothingIsNoticed) {
    const std::optional<Event> event = afterSending(60, 10ms);
    ASSERT_TRUE(event);
    EXPECT_EQ(event->code, EventCode::StoppedOnNoEcho);
}

} // namespace
} // namespace hexapose
