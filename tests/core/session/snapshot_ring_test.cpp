// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/snapshot_ring.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

SnapshotPtr cycleAt(std::uint64_t cycle, std::chrono::nanoseconds time) {
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->cycle = cycle;
    snapshot->time = time;
    return snapshot;
}

std::vector<std::uint64_t> cyclesOf(SnapshotReader& reader) {
    std::vector<std::uint64_t> cycles;
    for (const SnapshotPtr& snapshot : reader.take())
        cycles.push_back(snapshot->cycle);
    return cycles;
}

TEST(SnapshotRing, GivesEveryReaderEveryCycleOnce) {
    const auto ring = std::make_shared<SnapshotRing>(30s);
    SnapshotReader screen(ring);
    ring->publish(cycleAt(0, 0s));
    ring->publish(cycleAt(1, 1s));
    EXPECT_THAT(cyclesOf(screen), ElementsAre(0, 1));
    ring->publish(cycleAt(2, 2s));
    SnapshotReader bridge(ring); // comes later, and gets all that is kept
    EXPECT_THAT(cyclesOf(screen), ElementsAre(2));
    EXPECT_THAT(cyclesOf(screen), IsEmpty());
    EXPECT_THAT(cyclesOf(bridge), ElementsAre(0, 1, 2));
}

TEST(SnapshotRing, SharesTheCycleAndCopiesNone) {
    const auto ring = std::make_shared<SnapshotRing>(30s);
    SnapshotReader screen(ring), bridge(ring);
    const SnapshotPtr published = cycleAt(7, 0s);
    ring->publish(published);
    EXPECT_EQ(screen.take().front(), published);
    EXPECT_EQ(bridge.take().front(), published);
}

TEST(SnapshotRing, AReaderThatAsksTooSeldomMissesTheOldest) {
    const auto ring = std::make_shared<SnapshotRing>(2s);
    SnapshotReader reader(ring);
    for (std::uint64_t cycle = 0; cycle < 10; ++cycle)
        ring->publish(cycleAt(cycle, std::chrono::seconds(cycle)));
    EXPECT_THAT(cyclesOf(reader), ElementsAre(7, 8, 9));
    ring->publish(cycleAt(10, 10s));
    EXPECT_THAT(cyclesOf(reader), ElementsAre(10));
}

TEST(SnapshotRing, AnotherSessionBeginsEmptyForEveryReader) {
    const auto ring = std::make_shared<SnapshotRing>(30s);
    SnapshotReader read(ring), unread(ring);
    ring->publish(cycleAt(1, 5s));
    EXPECT_THAT(cyclesOf(read), ElementsAre(1));
    ring->clear();
    EXPECT_THAT(cyclesOf(unread), IsEmpty());
    ring->publish(cycleAt(0, 0s)); // its time begins anew
    EXPECT_THAT(cyclesOf(read), ElementsAre(0));
    EXPECT_THAT(cyclesOf(unread), ElementsAre(0));
}

TEST(SnapshotRing, WaitEndsWithTheNextCycleOrTheTime) {
    const auto ring = std::make_shared<SnapshotRing>(30s);
    SnapshotReader reader(ring);
    EXPECT_FALSE(reader.wait(1ms));
    std::jthread loop([&] { ring->publish(cycleAt(0, 0s)); });
    while (!reader.wait(100ms)) {
    }
    EXPECT_THAT(cyclesOf(reader), ElementsAre(0));
    EXPECT_FALSE(reader.wait(1ms)) << "it has been taken";
    EXPECT_FALSE(SnapshotReader().wait(1ms));
    EXPECT_THAT(SnapshotReader().take(), IsEmpty());
}

} // namespace
} // namespace hexapose
