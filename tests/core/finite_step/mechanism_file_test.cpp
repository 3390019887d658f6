// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Files of mechanisms that are wrong: each is refused with one line that says where, what and why.
#include "core/base/input_error.h"
#include "core/base/text_file.h"
#include "tests/core/finite_step/finite_step_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hexapose::testing::file_test {
namespace {

using ::testing::HasSubstr;

/// A point on three legs, which cannot turn: the smallest mechanism there is.
const std::string kTripod = R"(format = 1
name = "Tripod"
[output]
position_mm = [0, 0, 100]
turns = false
[[fixed]]
name = "A1"
position_mm = [100, 0, 0]
[[fixed]]
name = "A2"
position_mm = [-50, 80, 0]
[[fixed]]
name = "A3"
position_mm = [-50, -80, 0]
[[node]]
name = "B"
home_mm = [0, 0, 100]
[[actuator]]
name = "l1"
kind = "ups"
base = "A1"
node = "B"
[[actuator]]
name = "l2"
kind = "ups"
base = "A2"
node = "B"
[[actuator]]
name = "l3"
kind = "ups"
base = "A3"
node = "B"
)";

std::string replaced(const std::string& from, const std::string& to) {
    std::string text = kTripod;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string refusal(const std::string& toml) {
    try {
        const StepSystem system(parseMechanism(toml, "m.toml"), "m.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(MechanismFile, APointOnThreeLegsIsAMechanism) {
    const StepSystem system(parseMechanism(kTripod, "m.toml"), "m.toml");
    EXPECT_EQ(system.unknowns(), 3);
    EXPECT_NEAR(system.homeDrive()[0], std::sqrt(0.02), 1e-15);
}

struct BadFile {
    const char* from;
    const char* to;
    const char* said;
};

class BadMechanism : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadMechanism, IsRefusedInOneLine) {
    const std::string said = refusal(replaced(GetParam().from, GetParam().to));
    EXPECT_THAT(said, HasSubstr(GetParam().said));
    EXPECT_THAT(said, ::testing::StartsWith("m.toml:"));
    EXPECT_EQ(said.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadMechanism,
    ::testing::Values(
        BadFile{"format = 1", "format = 2", "m.toml:1: unknown format 2, expected 1"},
        BadFile{"format = 1\n", "", "missing key \"format\""},
        BadFile{"format = 1", "format = \"1\"", "m.toml:1: format"},
        BadFile{"name = \"Tripod\"", "name = 3", "m.toml:2: name is an integer, not text"},
        BadFile{"turns = false", "turns = 0", "m.toml:5: output: turns is an integer, not true or false"},
        BadFile{"turns = false", "turns = true", "output: how it is turned"},
        BadFile{"turns = false", "spins = false", "m.toml:5: output: unknown key \"spins\""},
        BadFile{"turns = false", "pivot = \"B\"", "output: pivot names \"B\", which is not fixed"},
        BadFile{"turns = false", "turns = false\npivot = \"A1\"", "output: pivot is of no use"},
        BadFile{"[output]\nposition_mm = [0, 0, 100]", "[output]", "output: missing key \"position_mm\""},
        BadFile{"[100, 0, 0]", "[100, nan, 0]", "m.toml:8: fixed 1: position_mm[1] is nan"},
        BadFile{"[100, 0, 0]", "[100, inf, 0]", "fixed 1: position_mm[1] is inf"},
        BadFile{"[100, 0, 0]", "[100, 1e200, 0]", "fixed 1: position_mm[1] is 1e+200"},
        BadFile{"[100, 0, 0]", "[100, \"0\", 0]", "position_mm[1] is text, not a number"},
        BadFile{"[100, 0, 0]", "[100, 0]", "m.toml:8: fixed 1: position_mm has 2 numbers, expected 3"},
        BadFile{"[100, 0, 0]", "[100 0 0]", "m.toml:8"},
        BadFile{"name = \"A2\"", "name = \"A1\"", "m.toml:10: fixed 2: another point is called \"A1\""},
        BadFile{"name = \"A2\"", "name = \"A,2\"", "fixed 2: name \"A,2\" has other characters"},
        BadFile{"name = \"A2\"\n", "", "fixed 2: missing key \"name\""},
        BadFile{"name = \"l2\"", "name = \"l1\"", "another actuator is called \"l1\""},
        BadFile{"kind = \"ups\"", "kind = \"upsala\"", "unknown kind \"upsala\" (known: ups, pus, rus)"},
        BadFile{"base = \"A1\"", "base = \"A9\"", "actuator 1: base: no point is called \"A9\""},
        BadFile{"base = \"A1\"", "base = \"B\"", "its two ends are one point at home"},
        BadFile{"base = \"A1\"", "root = \"A1\"", "actuator 1: unknown key \"root\""},
        BadFile{"base = \"A1\"", "base = \"A1\"\nspeed = 3", "actuator 1: unknown key \"speed\""},
        BadFile{"base = \"A1\"", "base = \"A2\"",
                "3 equations of rank 2 at home: actuator l2 follows from actuator l1"},
        BadFile{"home_mm = [0, 0, 100]", "home_mm = [0, 0, 0]", "of rank 2 at home"},
        BadFile{"home_mm = [0, 0, 100]", "home_mm = [0, 0, 100]\n[[node]]\nname = \"C\"\nhome_mm = [1, 2, 3]",
                "3 equations for 6 unknowns: not square"},
        BadFile{"[[fixed]]", "[extra]\nkey = 1\n[[fixed]]", "unknown key \"extra\""},
        BadFile{"[[fixed]]", "[[rigid]]\nkind = \"distance\"\npoints = [\"B\"]\n[[fixed]]",
                "rigid 1: points is not a list of 2 names"},
        BadFile{"[[fixed]]", "[[rigid]]\nkind = \"distance\"\npoints = [\"B\", \"B\"]\n[[fixed]]",
                "rigid 1: points names one twice"},
        BadFile{"[[fixed]]", "[[special]]\nkind = \"plane\"\npoint = \"B\"\nnormal = [0, 0, 0]\n[[fixed]]",
                "special 1: normal has no direction"},
        BadFile{
            "[[fixed]]",
            "[[special]]\nkind = \"circle\"\ncentre = \"B\"\npoints = [\"A1\", \"A2\", \"A3\"]\n[[fixed]]",
            "special 1: the centre is not the mean"},
        BadFile{"kind = \"ups\"\nbase = \"A1\"",
                "kind = \"rus\"\ncentre_mm = [9, 9, 0]\naxis = [0, 0, 1]\ncrank_mm = [9, 9, 5]",
                "actuator 1: the end of the crank lies on its axis"},
        BadFile{"base = \"A1\"", "base = \"A1\"\nreference = { amplitude_deg = 1, rate_deg_per_s = 1 }",
                "reference: unknown key \"amplitude_deg\""},
        BadFile{"[[actuator]]", "[[actuator]", "m.toml:18"}));

TEST(MechanismFile, CarriersMustSpanATriangle) {
    const std::string sixUps = readTextFile(mechanismFile("6-ups"));
    const std::string carriers = "carried_by = [\"B1\", \"B3\", \"B5\"]";
    for (const auto& [to, said] :
         {std::pair{"carried_by = [\"B1\", \"B3\"]", "not a list of three or four names"},
          {"carried_by = [\"B1\", \"B3\", \"B3\"]", "three nodes on one line"},
          {"carried_by = [\"B1\", \"B3\", \"A3\"]", "fixed or carried itself"},
          {"carried_by = [\"B1\", \"B3\", \"B4\"]", "fixed or carried itself"}}) {
        std::string text = sixUps;
        text.replace(text.find(carriers), carriers.size(), to);
        EXPECT_THAT(refusal(text), HasSubstr(said));
    }
    EXPECT_EQ(refusal(sixUps), "accepted");
}

TEST(MechanismFile, OneThatIsNotThereCannotBeRead) {
    EXPECT_THROW(loadMechanism("/nowhere/at/all.toml"), InputError);
}

} // namespace
} // namespace hexapose::testing::file_test
