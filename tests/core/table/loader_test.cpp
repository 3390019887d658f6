// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Reading on several threads, block by block.

#include "core/table/line_blocks.h"
#include "tests/core/table/table_files.h"

#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <thread>
#include <unistd.h>

namespace hexapose {
namespace {

using namespace testing_support;

constexpr int kRows = 100000; ///< three blocks

/// Some blocks of rows with words, quotes over line ends, blank lines and bad rows.
std::string largeText(int rows) {
    std::string text = "time_s,a,b,event\n";
    for (int i = 0; i < rows; ++i) {
        const std::string n = std::to_string(i);
        text += n + "," + std::to_string(0.5 * i) + ",";
        if (i % 97 == 0)
            text += "bad";
        else if (i % 89 != 0)
            text += std::to_string(-i);
        if (i % 1009 == 0)
            text += ",\"lines,\nof event " + n + "\"\n\n";
        else if (i % 1013 == 0)
            text += "\n";
        else
            text += i % 2 == 0 ? ",even\n" : ",\n";
    }
    return text;
}

TEST(Loader, ManyThreadsReadWhatOneReads) {
    const Folder folder;
    const auto file = folder.write("large.csv", largeText(kRows));
    TableLoader one(file, {{}, 1, {}}), four(file, {{}, 4, {}});
    one.wait();
    four.wait();
    ASSERT_GT(one.table()->rowCount(), 95000U);
    expectSame(*one.table(), *four.table());
    const Table& table = *four.table();
    for (Row row = 0; row < table.rowCount(); row += 1013)
        ASSERT_EQ(table.columns()[1].number(row), 0.5 * table.time().seconds(row));
    EXPECT_EQ(table.problems().rowsLeftOut, 98U);
    // A row's line: the number of line ends before its text.
    const std::string text = largeText(kRows);
    const std::string start = "\n" + std::to_string(80000) + ",";
    const auto before = text.begin() + static_cast<std::ptrdiff_t>(text.find(start)) + 1;
    const auto row = table.time().lastAtOrBefore(80000.0);
    ASSERT_TRUE(row);
    EXPECT_EQ(table.lineOf(*row), 1 + std::count(text.begin(), before, '\n'));
}

TEST(Loader, ATableIsUsableWhileItGrowsAndEarlierOnesStayAsTheyWere) {
    const Folder folder;
    const auto file = folder.write("large.csv", largeText(kRows));
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<std::shared_ptr<const Table>> seen;
    std::atomic<TableLoader*> self{nullptr};
    {
        TableLoader loader(file, {{}, 2, [&] {
                                      if (TableLoader* l = self.load()) {
                                          const std::lock_guard lock(mutex);
                                          seen.push_back(l->table());
                                          changed.notify_one();
                                      }
                                  }});
        self = &loader;
        loader.wait();
        seen.push_back(loader.table());
        EXPECT_TRUE(loader.progress().isDone);
        EXPECT_EQ(loader.progress().bytesRead, loader.progress().bytesInAll);
        self = nullptr;
    }
    for (const auto& table : seen)
        for (Row row = 0; row < table->rowCount(); row += 997)
            ASSERT_EQ(table->columns()[1].number(row), 0.5 * table->time().seconds(row));
}

TEST(Loader, CancelKeepsWhatWasRead) {
    const Folder folder;
    const auto file = folder.write("large.csv", largeText(kRows));
    TableLoader loader(file, {{}, 2, {}});
    loader.cancel();
    loader.wait();
    EXPECT_TRUE(loader.progress().isDone);
    EXPECT_FALSE(loader.progress().error);
    EXPECT_LE(loader.table()->rowCount(), Row{kRows});
}

TEST(Loader, AFileThatShrinksEndsEarly) {
    const Folder folder;
    const std::string text = largeText(kRows);
    const auto file = folder.write("large.csv", text);
    std::atomic<bool> cut{false};
    TableLoader loader(file, {{}, 2, [&] {
                                  if (!cut.exchange(true))
                                      ::truncate(file.c_str(), 1000);
                              }});
    loader.wait();
    EXPECT_FALSE(loader.progress().error);
    for (Row row = 0; row < loader.table()->rowCount(); row += 101)
        ASSERT_EQ(loader.table()->columns()[1].number(row), 0.5 * loader.table()->time().seconds(row));
}

TEST(Loader, ALineThatIsTooLongIsLeftOut) {
    const Folder folder;
    const auto file = folder / "long.csv";
    {
        std::ofstream out(file, std::ios::binary);
        out << "t,a\n0,1\n";
        const std::string piece(1 << 20, 'x');
        for (std::size_t i = 0; i < (LineBlocks::kLongestLine >> 20) + 3; ++i)
            out << piece;
        out << "\n2,3\n";
    }
    const auto table = loadTable(file);
    EXPECT_EQ(numbersOf(*table, "a"), (std::vector<double>{1.0, 3.0}));
    ASSERT_EQ(table->problems().count, 1U);
    EXPECT_EQ(table->problems().first[0].line, 3);
    EXPECT_EQ(table->lineOf(1), 4);
}

TEST(Loader, ASilentPipeDoesNotHoldUpACancel) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    {
        TableLoader loader("/proc/self/fd/" + std::to_string(ends[0]), {{}, 1, {}});
        loader.cancel();
        loader.wait();
        EXPECT_TRUE(loader.progress().isDone);
    }
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST(Loader, ReadsAPipe) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const std::string text = "t,a\n0,1\n1,2\n";
    std::thread writer([&] {
        EXPECT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
        ::close(ends[1]);
    });
    const auto table = loadTable("/proc/self/fd/" + std::to_string(ends[0]));
    writer.join();
    ::close(ends[0]);
    EXPECT_EQ(table->rowCount(), 2U);
}

} // namespace
} // namespace hexapose
