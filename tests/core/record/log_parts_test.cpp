// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// A log in several files: by size, because somebody took the file away, compressed.

#include "core/record/event_codec.h"
#include "core/record/log_columns.h"
#include "core/record/log_reader.h"
#include "core/record/log_writer.h"
#include "core/table/gzip_file.h"
#include "core/table/table_loader.h"
#include "tests/core/record/record_fixture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <chrono>

namespace hexapose {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class LogPartsTest : public testing::Test {
protected:
    void append(LogWriter& writer, int rows) {
        for (int i = 0; i < rows; ++i)
            writer.append(fullSnapshot(m_next++));
    }
    static bool holdsRows(const fs::path& file, std::size_t rows) {
        return comesTrue([&] { return lineCount(file) == rows + 1; });
    }
    /// All events that the writer tells until there is one of this code.
    std::vector<Event> eventsUntil(LogWriter& writer, EventCode code) {
        std::vector<Event> events;
        EXPECT_TRUE(comesTrue([&] {
            writer.takeEvents(events);
            return std::any_of(events.begin(), events.end(), [&](const Event& e) { return e.code == code; });
        }));
        return events;
    }
    /// The rows of all these files, which belong together.
    std::vector<std::chrono::nanoseconds> timesOf(const std::vector<std::string>& names) {
        std::vector<std::chrono::nanoseconds> times;
        for (const std::string& name : names) {
            const SessionLog log = readSessionLog(scratch / name);
            EXPECT_THAT(log.warnings, testing::IsEmpty()) << name;
            EXPECT_TRUE(log.platform) << name << " has no metadata";
            for (const Snapshot& row : log.rows)
                times.push_back(row.time);
        }
        return times;
    }
    void expectAllRows(const std::vector<std::string>& names) {
        const std::vector<std::chrono::nanoseconds> times = timesOf(names);
        ASSERT_EQ(times.size(), static_cast<std::size_t>(m_next));
        for (int i = 0; i < m_next; ++i)
            ASSERT_EQ(times[static_cast<std::size_t>(i)], fullSnapshot(i).time) << "row " << i;
    }
    std::vector<std::string> csvFiles() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(scratch / ""))
            if (entry.path().extension() != ".toml")
                names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }
    static LogOptions partsOf(std::uint64_t bytes) {
        LogOptions options = ofAnyDisk();
        options.partBytes = bytes;
        return options;
    }

    const ScratchDirectory scratch;
    const fs::path file = scratch / "run.csv";
    const LogMetadata metadata = sampleMetadata();
    int m_next = 0;
};

TEST_F(LogPartsTest, AFullPartIsFollowedByAnother) {
    constexpr std::uint64_t kPart = 20000;
    {
        LogWriter writer(file, metadata, partsOf(kPart));
        append(writer, 150);
        writer.finish();
        EXPECT_EQ(writer.file().filename(), csvFiles().at(csvFiles().size() - 2))
            << "run.csv is the last by name";
        EXPECT_FALSE(writer.failure());
        std::vector<Event> events;
        writer.takeEvents(events);
        ASSERT_EQ(events.size(), csvFiles().size() - 1);
        EXPECT_EQ(formatEvent(events[0]), "log-continued run-2.csv");
    }
    ASSERT_GE(csvFiles().size(), 3U);
    std::vector<std::string> names{"run.csv"};
    for (std::size_t i = 2; i <= csvFiles().size(); ++i)
        names.push_back("run-" + std::to_string(i) + ".csv");
    expectAllRows(names);
    for (const std::string& name : names)
        EXPECT_LE(fs::file_size(scratch / name), kPart) << name;
    EXPECT_THAT(readAll(scratch / "run-3.toml"), HasSubstr("\npart = 3\nfirst_part = 'run.csv'\n"));
    EXPECT_THAT(readAll(scratch / "run.toml"), Not(HasSubstr("part =")));
    EXPECT_EQ(readLogMetadata(scratch / "run-3.toml").port, metadata.port);
}

TEST_F(LogPartsTest, EveryPartHoldsARowHoweverSmallItMayBe) {
    {
        LogWriter writer(file, metadata, partsOf(1));
        append(writer, 4);
    }
    expectAllRows({"run.csv", "run-2.csv", "run-3.csv", "run-4.csv"});
}

TEST_F(LogPartsTest, APartNamesTheSolverItBeginsWith) {
    {
        LogWriter writer(file, metadata, partsOf(5000));
        Snapshot changed = fullSnapshot(m_next++);
        changed.events = {{EventCode::SolverChanged, SolverChoice{"newton", ""}}};
        writer.append(changed);
        append(writer, 20);
    }
    EXPECT_EQ(readLogMetadata(scratch / "run.toml").solver, metadata.solver);
    EXPECT_EQ(readLogMetadata(scratch / "run-2.toml").solver, "newton");
}

TEST_F(LogPartsTest, NamesThatAreTakenAreLeftAlone) {
    scratch.write("run-2.csv", "precious");
    scratch.write("run-3.toml", "precious too");
    scratch.write("run-4.csv.gz", "and this");
    {
        LogWriter writer(file, metadata, partsOf(20000));
        append(writer, 60);
    }
    EXPECT_EQ(readAll(scratch / "run-2.csv"), "precious");
    EXPECT_EQ(readAll(scratch / "run-3.toml"), "precious too");
    EXPECT_EQ(readAll(scratch / "run-4.csv.gz"), "and this");
    EXPECT_FALSE(fs::exists(scratch / "run-3.csv"));
    EXPECT_FALSE(fs::exists(scratch / "run-4.csv"));
    expectAllRows({"run.csv", "run-5.csv"});
}

TEST_F(LogPartsTest, ADeletedFileIsWrittenAgainWhole) {
    {
        LogWriter writer(file, metadata, ofAnyDisk());
        append(writer, 1000);
        ASSERT_TRUE(holdsRows(file, 1000));
        fs::remove(file);
        append(writer, 500);
        const std::vector<Event> events = eventsUntil(writer, EventCode::LogContinued);
        EXPECT_EQ(formatEvent(events.back()), "log-continued run-2.csv: the file before it was deleted");
        EXPECT_EQ(writer.file(), scratch / "run-2.csv");
        append(writer, 500);
    }
    EXPECT_FALSE(fs::exists(file));
    expectAllRows({"run-2.csv"});
}

TEST_F(LogPartsTest, OfSeveralPartsOnlyTheDeletedOneIsWrittenAgain) {
    {
        LogWriter writer(file, metadata, partsOf(20000));
        append(writer, 60);
        ASSERT_TRUE(comesTrue(
            [&] { return writer.file() == scratch / "run-2.csv" && lineCount(writer.file()) > 5; }));
        fs::remove(scratch / "run-2.csv");
        eventsUntil(writer, EventCode::LogContinued);
        ASSERT_TRUE(comesTrue([&] { return writer.file() == scratch / "run-3.csv"; }));
        append(writer, 70);
    }
    expectAllRows({"run.csv", "run-3.csv", "run-4.csv"});
}

TEST_F(LogPartsTest, ADirectoryThatWasDeletedIsMadeAgain) {
    const fs::path deep = scratch / "logs";
    fs::create_directory(deep);
    {
        LogWriter writer(deep / "run.csv", metadata, ofAnyDisk());
        append(writer, 100);
        ASSERT_TRUE(holdsRows(deep / "run.csv", 100));
        fs::remove_all(deep);
        append(writer, 100);
    }
    expectAllRows({"logs/run-2.csv"});
}

TEST_F(LogPartsTest, AFileThatWasMovedKeepsItsRows) {
    {
        LogWriter writer(file, metadata, ofAnyDisk());
        append(writer, 100);
        ASSERT_TRUE(holdsRows(file, 100));
        fs::rename(file, scratch / "run-moved.csv");
        fs::copy_file(scratch / "run.toml", scratch / "run-moved.toml");
        scratch.write("run.csv", "another's");
        const std::vector<Event> events = eventsUntil(writer, EventCode::LogContinued);
        EXPECT_EQ(formatEvent(events.back()),
                  "log-continued run-2.csv: the file before it was moved or replaced");
        append(writer, 100);
    }
    EXPECT_EQ(readAll(file), "another's");
    expectAllRows({"run-moved.csv", "run-2.csv"});
}

TEST_F(LogPartsTest, AFileThatWasReplacedIsWrittenAgainWhole) {
    {
        LogWriter writer(file, metadata, ofAnyDisk());
        append(writer, 100);
        ASSERT_TRUE(holdsRows(file, 100));
        fs::rename(scratch.write("other.csv", "another's"), file); // as an editor saves
        eventsUntil(writer, EventCode::LogContinued);
        append(writer, 100);
    }
    EXPECT_EQ(readAll(file), "another's");
    expectAllRows({"run-2.csv"});
}

TEST_F(LogPartsTest, ALogThatWasCutGoesOnInAnother) {
    {
        LogWriter writer(file, metadata, ofAnyDisk());
        append(writer, 100);
        ASSERT_TRUE(holdsRows(file, 100));
        fs::resize_file(file, 0);
        eventsUntil(writer, EventCode::LogContinued);
        append(writer, 100);
    }
    EXPECT_EQ(readSessionLog(scratch / "run-2.csv").rows.size(), 100U);
}

TEST_F(LogPartsTest, ClosedPartsAreCompressed) {
    LogOptions options = partsOf(20000);
    options.compress = gzipFile;
    {
        LogWriter writer(file, metadata, options);
        append(writer, 150);
    }
    const std::vector<std::string> names = csvFiles();
    ASSERT_GE(names.size(), 3U);
    std::size_t rows = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        rows += loadTable(scratch / names[i])->rowCount();
        EXPECT_TRUE(fs::exists(logMetadataFile(scratch / names[i]))) << names[i];
    }
    EXPECT_EQ(rows, 150U);
    EXPECT_EQ(std::count_if(names.begin(), names.end(), [](const auto& n) { return n.ends_with(".csv.gz"); }),
              static_cast<std::ptrdiff_t>(names.size() - 1))
        << "all but the one that was being written";
    EXPECT_THAT(names, testing::Contains("run.csv.gz"));
}

TEST_F(LogPartsTest, ACompressionThatFailsLeavesThePart) {
    LogOptions options = partsOf(20000);
    options.compress = [](const fs::path&, const fs::path&, const std::stop_token&) { return false; };
    {
        LogWriter writer(file, metadata, options);
        append(writer, 60);
    }
    expectAllRows({"run.csv", "run-2.csv"});
}

TEST_F(LogPartsTest, TellsOfADiskThatIsGettingFull) {
    LogOptions options;
    std::atomic<std::uint64_t> free = 3'000'000'000;
    options.freeSpace = [&](const fs::path& directory) {
        EXPECT_EQ(directory, file.parent_path());
        return std::optional<std::uint64_t>(free);
    };
    options.watchDiskEvery = std::chrono::milliseconds(1);
    LogWriter writer(scratch / "run.csv", metadata, options);
    append(writer, 100);
    ASSERT_TRUE(holdsRows(file, 100));
    std::vector<Event> events;
    writer.takeEvents(events);
    EXPECT_THAT(events, testing::IsEmpty());
    free = 1'900'000'000;
    events = eventsUntil(writer, EventCode::LogSpaceLow);
    EXPECT_THAT(formatEvent(events.back()), testing::StartsWith("log-space-low 1.90 GB"));
    EXPECT_FALSE(writer.failure()) << "all is being written";
}

} // namespace
} // namespace hexapose
