// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Platform files broken in one line each: the message names the file, that line and the cause.
#include "tests/app/bad_call.h"
#include "tests/app/machine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace hexapose::apptest {
namespace {

// As Machine::toml() writes it: leg n begins in line 5 n.
enum Line {
    kFormat = 1,
    kName,
    kHome,
    kHomePosition,
    kLeg1,
    kBase1,
    kPlatform1,
    kMin1,
    kMax1,
    kLeg2,
    kBase2,
    kPlatform2
};
constexpr int kLegLines = 5;
constexpr int leg(int number, int line) {
    return line + (number - 1) * kLegLines;
}

struct Break {
    int line; ///< replaced
    std::string by;
    std::vector<std::string> said;
    int told = 0; ///< the line that is named, when it is another
};

std::string broken(const std::string& text, int line, const std::string& by) {
    std::istringstream in(text);
    std::string result;
    int number = 0;
    for (std::string old; std::getline(in, old);)
        result += (++number == line ? by : old) + "\n";
    return result;
}

TEST(BadPlatform, IsNamedWithItsLine) {
    const std::vector<Break> breaks{
        {kFormat, "format = 2", {"format", "2"}},
        {kFormat, "format = \"1\"", {"format"}},
        {kFormat, "format = = 1", {}},
        {kFormat, "", {"format"}},
        {kName, "name = 5", {"name"}},
        {kName, "", {"name"}, 1},
        {kName, "nickname = \"x\"", {}, -1},
        {kName, "name = \"x\"\ncolour = \"red\"", {"unknown", "colour"}, 3},
        {kHome, "[house]", {}, -1},
        {kHomePosition, "position_mm = [0, 0]", {"position_mm", "3"}},
        {kHomePosition, "position_mm = [0, 0, nan]", {"position_mm", "nan"}},
        {kHomePosition, "position_mm = [0, 0, inf]", {"position_mm", "inf"}},
        {kHomePosition, "position_mm = [0, 0, \"272.9\"]", {"position_mm"}},
        {kHomePosition, "position_mm = 272.9", {"position_mm"}},
        {kHomePosition, "position_m = [0, 0, 0.2729]", {}, -1},
        {kHomePosition, "position_mm = [0, 0, 272.9", {}, -1},
        {kHomePosition, "position_mm = [0, 0, 672.9]", {"leg", "above max_mm", "350"}, -1},
        {kHomePosition, "position_mm = [0, 0, 72.9]", {"leg", "below min_mm", "250"}, -1},
        {leg(3, kBase1), "base_mm = [171.85, -70.35]", {"leg 3", "base_mm"}},
        {leg(3, kBase1), "base_mm = [171.85, nan, 52.5]", {"leg 3", "base_mm", "nan"}},
        {leg(3, kBase1), "base_mm = [171.85, -70.35, 1e500]", {}, -1},
        {leg(3, kBase1), "", {"leg 3", "base_mm"}, leg(3, kLeg1)},
        {leg(4, kPlatform1), "platform_mm = [true, 0, 0]", {"leg 4", "platform_mm"}},
        {leg(4, kPlatform1), "platform_mm = []", {"leg 4", "platform_mm"}},
        {leg(4, kPlatform1), "plattform_mm = [22.5, -110, 52.5]", {"leg 4", "plattform_mm"}, -1},
        {leg(5, kMin1), "min_mm = 350", {"leg 5", "min_mm", "350"}},
        {leg(5, kMin1), "min_mm = 400", {"leg 5", "min_mm 400", "350"}},
        {leg(5, kMin1), "min_mm = -10", {"leg 5", "min_mm", "-10"}},
        {leg(5, kMin1), "min_mm = nan", {"leg 5", "min_mm", "nan"}},
        {leg(5, kMin1), "min_mm = 310", {"leg 5", "min_mm", "310"}},
        {leg(5, kMax1), "max_mm = inf", {"leg 5", "max_mm", "inf"}},
        {leg(5, kMax1), "max_mm = 280", {"leg 5", "max_mm", "280"}},
        {leg(5, kMax1), "max_mm = \"350\"", {"leg 5", "max_mm"}},
        {leg(5, kMax1), "max_mm = 350\nmax_mm = 360", {"max_mm"}, leg(5, kMax1) + 1},
        {leg(6, kLeg1), "[[legs]]", {"unknown", "legs"}, leg(6, kLeg1)},
        {leg(6, kMax1),
         "max_mm = 350\nspeed_mm_s = 3",
         {"leg 6", "unknown", "speed_mm_s"},
         leg(6, kMax1) + 1},
    };
    const Scratch scratch;
    const std::string text = laboratory().toml();
    scratch.file("lengths.csv", "l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n300,300,300,300,300,300\n");
    std::vector<BadCall> calls;
    for (const Break& b : breaks) {
        const std::string name = "broken-" + std::to_string(calls.size()) + ".toml";
        scratch.file(name, broken(text, b.line, b.by));
        std::vector<std::string> said = b.said;
        said.push_back("@" + name + ":" +
                       (b.told < 0 ? "" : std::to_string(b.told > 0 ? b.told : b.line) + ":"));
        calls.push_back({"forward @lengths.csv --method newton --platform @" + name, said});
    }
    // Whole legs more or less, and joints in one place.
    const std::string leg6 = text.substr(text.rfind("[[leg]]"));
    scratch.file("five.toml", text.substr(0, text.rfind("[[leg]]")));
    scratch.file("seven.toml", text + leg6);
    Machine twin = laboratory();
    twin.base[1] = twin.base[0];
    twin.platform[1] = twin.platform[0];
    scratch.file("twin.toml", twin.toml());
    Machine line = laboratory();
    for (std::size_t i = 0; i < 6; ++i)
        line.base[i] = {50.0 * static_cast<double>(i) - 125.0, 0.0, 52.5};
    line.minMm = 1.0;
    line.maxMm = 1000.0;
    scratch.file("line.toml", line.toml());
    const std::string with = "inverse @lengths.csv --platform ";
    calls.push_back({with + "@five.toml", {"@five.toml:", "6 legs", "5"}});
    calls.push_back({with + "@seven.toml", {"@seven.toml:", "6 legs", "7"}});
    calls.push_back({with + "@twin.toml",
                     {"@twin.toml:" + std::to_string(kBase2) + ":", "leg 2", "coincident", "leg 1"}});
    calls.push_back({with + "@line.toml", {"@line.toml:", "base", "line"}});
    expectRefused(HEXAPOSE_CLI, scratch, calls);
}

/// Base and platform are similar: nothing can be measured or moved, and the program reports it at once.
TEST(BadPlatform, IsRefusedWithItsCauseWhereNothingCanMoveWithIt) {
    const Scratch scratch;
    Machine similar = laboratory();
    for (std::size_t i = 0; i < 6; ++i)
        similar.platform[i] = {0.5 * similar.base[i][0], 0.5 * similar.base[i][1], similar.platform[i][2]};
    similar.minMm = 1.0;
    similar.maxMm = 1000.0;
    scratch.file("similar.toml", similar.toml());
    scratch.file("targets.csv", "x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg\n0,0,1,0,0,0\n");
    const std::vector<std::string> said{"@similar.toml", "singular at home", "similar figures"};
    expectRefused(
        HEXAPOSE_CLI, scratch,
        {{"run --port virtual --targets @targets.csv --log @log.csv --platform @similar.toml", said}});
#ifdef HEXAPOSE_CONSOLE
    expectRefused(HEXAPOSE_CONSOLE, scratch,
                  {{"--headless --virtual --log-dir @ --platform @similar.toml", said}});
#endif
}

} // namespace
} // namespace hexapose::apptest
