// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/disk_watch.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t kGigabyte = 1'000'000'000;
constexpr DiskWatch::Time kBegin{1000s};

TEST(DiskWatch, WarnsBelowTwoGigabytesAndAgainAtHalves) {
    DiskWatch watch;
    EXPECT_FALSE(watch.update(kBegin, 2 * kGigabyte, 0));
    const auto first = watch.update(kBegin + 5s, 2 * kGigabyte - 1, 0);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->freeBytes, 2 * kGigabyte - 1);
    EXPECT_FALSE(first->secondsLeft) << "nothing was written";
    EXPECT_FALSE(watch.update(kBegin + 10s, 2 * kGigabyte - 2, 0)) << "once is enough";
    EXPECT_TRUE(watch.update(kBegin + 15s, kGigabyte - 2, 0));
    EXPECT_FALSE(watch.update(kBegin + 20s, 2 * kGigabyte + 1, 0));
    EXPECT_FALSE(watch.update(kBegin + 25s, 2 * kGigabyte - 1, 0)) << "it swings about the limit";
    EXPECT_FALSE(watch.update(kBegin + 30s, 4 * kGigabyte, 0));
    EXPECT_TRUE(watch.update(kBegin + 35s, 2 * kGigabyte - 1, 0)) << "it had recovered";
}

TEST(DiskWatch, WarnsWhenLessThanAnHourIsLeftAtThePresentRate) {
    constexpr std::uint64_t kRate = 2'000'000; // bytes a second: an hour takes 7.2 GB
    DiskWatch watch;
    std::uint64_t written = 0;
    std::optional<LogSpace> warned;
    std::uint64_t free = 7'400'000'000;
    int seconds = 0;
    for (; seconds < 300 && !warned; seconds += 5, written += 5 * kRate, free -= 5 * kRate)
        warned = watch.update(kBegin + seconds * 1s, free, written);
    ASSERT_TRUE(warned);
    EXPECT_NEAR(static_cast<double>(warned->freeBytes), 7.2e9, 2e7);
    ASSERT_TRUE(warned->secondsLeft);
    EXPECT_NEAR(*warned->secondsLeft, 3600.0, 10.0);
    EXPECT_FALSE(watch.update(kBegin + seconds * 1s, free, written));
}

TEST(DiskWatch, AsksTheSystem) {
    EXPECT_TRUE(freeSpaceOf("."));
    EXPECT_TRUE(freeSpaceOf("")) << "of a file without a directory in its name";
    EXPECT_FALSE(freeSpaceOf("/no/such/directory"));
}

} // namespace
} // namespace hexapose
