// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "tests/architecture/source_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

namespace hexapose::architecture {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string readText(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

using Rule = std::function<std::vector<std::string>(std::string_view, std::string_view)>;

/// Every violation in the files below the folders; each folder must hold some, lest the test looks at
/// nothing.
std::vector<std::string> checkTree(const std::vector<std::string>& folders, const Rule& rule,
                                   const std::function<bool(const fs::path&)>& wanted) {
    const fs::path top = HEXAPOSE_SOURCE_DIR;
    std::vector<std::string> found;
    for (const std::string& folder : folders) {
        int count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
            if (entry.is_regular_file() && wanted(entry.path())) {
                ++count;
                const auto bad =
                    rule(entry.path().lexically_relative(top).generic_string(), readText(entry.path()));
                found.insert(found.end(), bad.begin(), bad.end());
            }
        }
        EXPECT_GT(count, 0) << folder;
    }
    return found;
}

bool isSource(const fs::path& file) {
    return file.extension() == ".cpp" || file.extension() == ".h";
}

std::vector<std::string> including(std::string_view path, const std::string& header) {
    return includeViolations(path, "#pragma once\n#include " + header + "\n");
}

TEST(Architecture, EveryArrowPointsTheAllowedWay) {
    EXPECT_THAT(checkTree({"core", "ui", "app"}, includeViolations, isSource), IsEmpty());
}

/// Not by way of other headers either: a change of the device interface compiles no picture and no panel.
TEST(Architecture, PicturesAndPanelsReachNoDevice) {
    const fs::path top = HEXAPOSE_SOURCE_DIR;
    std::set<std::string> seen;
    std::vector<std::string> reached;
    const std::function<void(const std::string&)> follow = [&](const std::string& path) {
        if (!seen.insert(path).second || !fs::exists(top / path))
            return;
        const std::string text = readText(top / path);
        const std::regex include(R"re(#include "([^"]+)")re");
        for (auto at = std::sregex_iterator(text.begin(), text.end(), include); at != std::sregex_iterator();
             ++at) {
            const std::string header = (*at)[1];
            if (header.starts_with("core/device/"))
                reached.push_back(path + " includes " + header);
            follow(header);
        }
    };
    for (const auto& entry : fs::recursive_directory_iterator(top / "ui"))
        if (isSource(entry.path()))
            follow(entry.path().lexically_relative(top).generic_string());
    EXPECT_TRUE(seen.contains("core/session/session.h"));
    EXPECT_THAT(reached, IsEmpty());
}

TEST(Architecture, CoreLinksQtOnlyInTheSerialFolder) {
    const auto isList = [](const fs::path& file) { return file.filename() == "CMakeLists.txt"; };
    EXPECT_THAT(checkTree({"core"}, linkViolations, isList), IsEmpty());
}

TEST(Architecture, EverySourceNamesItsLicence) {
    EXPECT_THAT(checkTree({"core", "ui", "app", "tests"}, headerViolations, isSource), IsEmpty());
}

TEST(Architecture, NoSourceGrowsOutOfHand) {
    EXPECT_THAT(checkTree({"core", "ui", "app", "tests"}, sizeViolations, isSource), IsEmpty());
}

TEST(Architecture, EverySourceIsInTheListOfItsFolder) {
    const auto rule = [](std::string_view path, std::string_view) {
        const fs::path top = HEXAPOSE_SOURCE_DIR;
        fs::path folder = fs::path(path).parent_path();
        while (!fs::exists(top / folder / "CMakeLists.txt"))
            folder = folder.parent_path();
        return listViolations(path, folder.generic_string(), readText(top / folder / "CMakeLists.txt"));
    };
    const auto isUnit = [](const fs::path& file) { return file.extension() == ".cpp"; };
    EXPECT_THAT(checkTree({"core", "ui", "app", "tests"}, rule, isUnit), IsEmpty());
}

TEST(SourceRules, ReversedArrowIsToldWithItsLine) {
    EXPECT_THAT(
        including("core/geometry/pose.h", "\"core/kinematics/jacobian.h\""),
        ElementsAre("core/geometry/pose.h:2: core/geometry must not include core/kinematics/jacobian.h"));
    // Written otherwise it is the same arrow.
    EXPECT_THAT(includeViolations("core/record/a.cpp", "  #  include <core/machine/move.h> // why\n"),
                ElementsAre(HasSubstr("core/record must not include")));
}

struct Arrow {
    const char* path;
    const char* header;
    bool allowed;
};

class Arrows : public testing::TestWithParam<Arrow> {};

TEST_P(Arrows, AreJudged) {
    const auto found = including(GetParam().path, GetParam().header);
    EXPECT_EQ(found.empty(), GetParam().allowed) << GetParam().path << " " << GetParam().header;
}

INSTANTIATE_TEST_SUITE_P(
    Table, Arrows,
    testing::Values(
        Arrow{"core/geometry/a.cpp", "\"core/geometry/a.h\"", true},
        Arrow{"core/kinematics/a.cpp", "\"core/geometry/pose.h\"", true},
        Arrow{"core/kinematics/a.cpp", "\"core/device/byte_channel.h\"", false},
        Arrow{"core/kinematics/a.cpp", "\"core/finite_step/leg_path.h\"", false},
        Arrow{"core/finite_step/a.cpp", "\"core/kinematics/jacobian.h\"", true},
        Arrow{"core/finite_step/a.cpp", "\"core/record/snapshot.h\"", false},
        Arrow{"core/device/a.cpp", "\"core/record/snapshot.h\"", true},
        // A folder's row does not open the layer inside it.
        Arrow{"core/device/a.cpp", "\"core/device/serial/serial_channel.h\"", false},
        Arrow{"core/device/serial/a.cpp", "\"core/device/byte_channel.h\"", true},
        Arrow{"core/record/a.h", "\"core/report/error_report.h\"", false},
        Arrow{"core/machine/a.h", "\"core/record/snapshot.h\"", true},
        Arrow{"core/machine/a.h", "\"core/report/error_report.h\"", false},
        Arrow{"core/report/a.h", "\"ui/report/report_export.h\"", false},
        Arrow{"core/geometry/a.cpp", "<QString>", false}, Arrow{"core/geometry/a.cpp", "<qglobal.h>", false},
        Arrow{"core/geometry/a.cpp", "<QtCore/QObject>", false},
        Arrow{"core/geometry/a.cpp", "<queue>", true},
        Arrow{"core/device/serial/a.cpp", "<QSerialPort>", true},
        Arrow{"ui/charts/a.cpp", "<QPainter>", true},
        Arrow{"core/geometry/geometry_file.cpp", "<toml++/toml.h>", true},
        Arrow{"core/record/log_writer.cpp", "<toml++/toml.h>", true},
        Arrow{"core/geometry/geometry_file.h", "<toml++/toml.h>", false},
        Arrow{"core/geometry/pose.cpp", "<toml++/toml.h>", false},
        Arrow{"core/base/toml_values.h", "<toml++/toml.h>", true},
        Arrow{"core/finite_step/mechanism_file.cpp", "\"core/base/toml_values.h\"", true},
        Arrow{"core/finite_step/mechanism.cpp", "\"core/base/toml_values.h\"", false},
        Arrow{"ui/console/motion/a.cpp", "<toml++/toml.h>", false},
        Arrow{"ui/charts/a.h", "\"core/record/snapshot.h\"", true},
        Arrow{"ui/charts/a.h", "\"ui/plot/plot.h\"", true},
        Arrow{"ui/plot/a.h", "\"ui/charts/time_chart.h\"", false},
        Arrow{"ui/charts/a.h", "\"core/machine/control_loop.h\"", false},
        Arrow{"ui/charts/a.h", "\"core/device/platform_device.h\"", false},
        Arrow{"core/session/a.h", "\"core/device/platform_device.h\"", true},
        Arrow{"core/session/a.h", "\"core/device/line/line_device.h\"", false},
        Arrow{"core/session/a.h", "\"ui/console/motion/target_panel.h\"", false},
        Arrow{"ui/console/motion/a.h", "\"core/device/serial/serial_ports.h\"", false},
        Arrow{"ui/console/window/a.h", "\"core/device/platform_device.h\"", false},
        Arrow{"ui/console/motion/a.h", "\"core/device/serial/serial_channel.h\"", false},
        Arrow{"ui/console/motion/a.h", "\"app/common/directories.h\"", false},
        Arrow{"app/cli/a.cpp", "\"ui/report/report_export.h\"", true},
        Arrow{"app/cli/a.cpp", "\"ui/console/window/operator_window.h\"", false},
        Arrow{"app/common/a.cpp", "\"ui/console/window/operator_window.h\"", false},
        Arrow{"app/console/main.cpp", "\"ui/console/motion/a.h\"", true},
        Arrow{"ui/console/motion/a.cpp", "\"tests/support/a.h\"", false},
        Arrow{"core/geometry/a.cpp", "\"../kinematics/jacobian.h\"", false},
        Arrow{"core/geometry/a.cpp", "\"pose.h\"", false}, Arrow{"ui/charts/a.cpp", "\"a.moc\"", false},
        Arrow{"ui/charts/a.cpp", "\"moc_a.cpp\"", true}, Arrow{"ui/charts/a.cpp", "\"moc_b.cpp\"", false},
        Arrow{"ui/charts/a.h", "\"moc_a.cpp\"", false}, Arrow{"core/novelty/a.cpp", "<vector>", false},
        Arrow{"core/a.cpp", "<vector>", false}));

TEST(SourceRules, EveryAllowedFolderHasARowItself) {
    for (const Layer& layer : layers()) {
        for (const std::string_view allowed : layer.mayInclude) {
            const bool known =
                allowed.ends_with(".h") || std::any_of(layers().begin(), layers().end(),
                                                       [&](const Layer& r) { return r.folder == allowed; });
            EXPECT_TRUE(known) << layer.folder << " -> " << allowed;
        }
    }
}

TEST(SourceRules, LicenceFollowsTheFolder) {
    const std::string mit =
        "// SPDX-FileCopyrightText: 2026 The Hexapose authors\n// SPDX-License-Identifier: MIT\n";
    const std::string gpl = "// SPDX-FileCopyrightText: 2026 The Hexapose authors\n// "
                            "SPDX-License-Identifier: GPL-3.0-or-later\n";
    EXPECT_THAT(headerViolations("core/geometry/pose.h", mit), IsEmpty());
    EXPECT_THAT(headerViolations("ui/charts/a.h", gpl), IsEmpty());
    EXPECT_THAT(headerViolations("tests/ui/a.cpp", gpl), IsEmpty());
    EXPECT_THAT(headerViolations("core/geometry/pose.h", gpl), ElementsAre(HasSubstr("licence MIT")));
    EXPECT_THAT(headerViolations("app/cli/main.cpp", mit),
                ElementsAre(HasSubstr("licence GPL-3.0-or-later")));
    EXPECT_THAT(headerViolations("core/geometry/pose.h", "#pragma once\n" + mit), testing::SizeIs(1));
}

TEST(SourceRules, ASourceThatNoListNamesIsTold) {
    const std::string list =
        "hexapose_test(jog_test\n  SOURCES move_test.cpp sub/more.cpp) # late_test.cpp\n";
    EXPECT_THAT(listViolations("tests/core/a/move_test.cpp", "tests/core/a", list), IsEmpty());
    EXPECT_THAT(listViolations("tests/core/a/sub/more.cpp", "tests/core/a", list), IsEmpty());
    for (const char* missing : {"tests/core/a/jog_test.cpp", "tests/core/a/more.cpp", "tests/core/a/test.cpp",
                                "tests/core/a/late_test.cpp"})
        EXPECT_THAT(listViolations(missing, "tests/core/a", list),
                    ElementsAre(HasSubstr("is not named in tests/core/a/CMakeLists.txt")))
            << missing;
    EXPECT_THAT(listViolations("tests/examples/01_a.cpp", "tests/examples", "example(01_a x)"), IsEmpty());
}

TEST(SourceRules, LongSourcesAndQtInCoreListsAreTold) {
    EXPECT_THAT(sizeViolations("core/a.cpp", std::string(400, '\n')), IsEmpty());
    EXPECT_THAT(sizeViolations("core/a.cpp", std::string(401, '\n')), ElementsAre(HasSubstr("401 lines")));
    EXPECT_THAT(linkViolations("core/record/CMakeLists.txt", "LINKS Qt6::Core"), testing::SizeIs(1));
    EXPECT_THAT(linkViolations("core/device/serial/CMakeLists.txt", "LINKS Qt6::SerialPort"), IsEmpty());
}

} // namespace
} // namespace hexapose::architecture
