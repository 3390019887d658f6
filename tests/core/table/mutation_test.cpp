// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Files with bytes changed, put in and taken out at random: read or refused, never a crash, and the same
// whatever the size of the blocks.

#include "core/base/input_error.h"
#include "core/table/line_blocks.h"
#include "core/table/reduction.h"
#include "core/table/statistics.h"
#include "tests/core/table/table_files.h"
#include "tests/support/sample_count.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace hexapose {
namespace {

using namespace testing_support;

const std::string kSamples[] = {
    "time_s,l1_mm,l2_mm,state,event\n0,1.5,2,ready,\n0.01,-1e3,,moving,\"begun, now\"\n0.02,3,4,moving,\n",
    "# by X\ntime;l1 [mm];note\n0,5;1,25;a\n1,0;2,5;\"b\nc\"\n1,5;3,75;d\n",
    "1\t2\t3\r\n4\t5\t6\r\n7\t8\t9\r\n",
    "timestamp,a,a,,b\n2026-11-29T12:00:00Z,1,2,3,4\n2026-11-29T12:00:01.5+01:00,1,2,3,x\n",
    "t_ms,x,y\nms,mm,deg\n0,1,2\n10,2,3\n5,3,4\n",
};

std::string mutated(std::string text, std::mt19937_64& random) {
    static constexpr char kSet[] = "0123456789.,;\t\"\n\r -+eE#\0\xFF\xC3|[]_";
    static const std::string kBytes(kSet, sizeof kSet - 1); // there is a NUL among them
    const auto count = 1 + random() % 4;
    for (std::uint64_t i = 0; i < count && !text.empty(); ++i) {
        const std::size_t at = random() % text.size();
        const char byte = kBytes[random() % kBytes.size()];
        switch (random() % 4) {
        case 0:
            text[at] = byte;
            break;
        case 1:
            text.insert(at, 1, byte);
            break;
        case 2:
            text.erase(at, 1 + random() % 8);
            break;
        default:
            text.resize(at);
        }
    }
    return text;
}

TEST(Mutation, IsReadOrRefusedAndBlocksDoNotMatter) {
    std::mt19937_64 random(7);
    const Folder folder;
    int read = 0, refused = 0;
    for (int i = 0; i < samples(1500); ++i) {
        const std::string text = mutated(kSamples[random() % std::size(kSamples)], random);
        SCOPED_TRACE(testing::PrintToString(text));
        const auto file = folder.write("m.csv", text);
        std::shared_ptr<const Table> table;
        try {
            table = loadTable(file);
        } catch (const InputError&) {
            ++refused;
            continue;
        }
        ++read;
        for (const Column& column : table->columns()) {
            statisticsOf(column, 0, table->rowCount());
            reduceToPixels(column, table->time(), {table->time().begin(), table->time().end(), 50});
        }
        TextSource source(file);
        std::string whole;
        for (std::array<char, 256> piece; const std::size_t size = source.read(piece);)
            whole.append(piece.data(), size);
        TableLoader::Options options;
        options.threads = 2;
        options.format = detectFormat(whole, true, "m.csv");
        options.blockSize = options.format->firstRowOffset + 1 + random() % 40;
        TableLoader other(file, options);
        other.wait();
        ASSERT_FALSE(other.progress().error);
        expectSame(*table, *other.table());
        if (HasFatalFailure())
            return;
    }
    EXPECT_GT(read, samples(1200));
    EXPECT_GT(refused, 0);
}

} // namespace
} // namespace hexapose
