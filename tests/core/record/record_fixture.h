// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/units.h"
#include "core/geometry/geometry_file.h"
#include "core/record/log_metadata.h"
#include "core/record/log_options.h"
#include "core/record/snapshot.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace hexapose {

inline const std::filesystem::path kLaboratoryFile =
    std::filesystem::path(HEXAPOSE_SOURCE_DIR) / "resources/platforms/laboratory.toml";

/// A directory of its own for each test, gone afterwards.
class ScratchDirectory {
public:
    ScratchDirectory() {
        std::string name = (std::filesystem::temp_directory_path() / "hexapose-record-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("no scratch directory");
        m_path = name;
    }
    ~ScratchDirectory() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(m_path / name, std::ios::binary) << text;
        return m_path / name;
    }

private:
    std::filesystem::path m_path;
};

inline std::string readAll(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

inline std::size_t lineCount(const std::filesystem::path& file) {
    const std::string text = readAll(file);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// How long something that another thread or process does may take before the test gives it up.
inline constexpr std::chrono::seconds kPatience{20};

template <typename Condition>
bool comesTrue(Condition condition) {
    const auto until = std::chrono::steady_clock::now() + kPatience;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > until)
            return false;
        std::this_thread::yield();
    }
    return true;
}

/// Of a log whose disk is never reported as getting full, as that of a machine that runs tests may be.
inline LogOptions ofAnyDisk() {
    LogOptions options;
    options.freeSpace = [](const std::filesystem::path&) { return std::nullopt; };
    return options;
}

inline LogMetadata sampleMetadata() {
    return {.platform = loadPlatform(kLaboratoryFile),
            .modelFingerprint = "0123456789abcdef",
            .solver = "mpr3-nr",
            .programVersion = "1.2.3",
            .port = "/dev/tty \"odd\"\\name",
            .firstPart = {}};
}

/// A cycle with every column filled.
inline Snapshot fullSnapshot(int number = 0) {
    Snapshot s;
    s.time = std::chrono::milliseconds(10 * number);
    s.wallTime = std::chrono::sys_days(std::chrono::year(2026) / 3 / 1) +
                 std::chrono::milliseconds(50709250 + 10 * number);
    s.state = RunState::Moving;
    s.fresh = true;
    s.stale = false;
    s.age = std::chrono::microseconds(1500);
    s.measuredLengths.emplace();
    *s.measuredLengths << 0.3395, 0.3365, 0.3366, 0.3292, 0.3451, 0.3345;
    s.commandedLengths = LegLengths::Constant(0.1 + 0.2);
    s.goalPose = Pose{{0.012, -0.004, 0.04}, {0.0, 0.0, radiansFromDeg(5.0)}};
    s.measuredPose = Pose{{0.01199, -0.00404, 0.03978}, {-1.686e-4, 5.838e-5, 0.08689}};
    s.status = SolveStatus::Converged;
    s.iterations = 3;
    s.residual = 1.25e-12;
    s.counters.droppedCrc = 2;
    s.counters.droppedOrder = 1;
    return s;
}

} // namespace hexapose
