// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Which sets of step equations determine a 6-UPS platform, and what is said of those that do not.
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "tests/core/finite_step/finite_step_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hexapose::testing::rank_test {
namespace {

using ::testing::HasSubstr;

using Pairs = std::vector<std::pair<int, int>>;
const Pairs kHexagon{{1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 1}};

std::string vectorText(const Eigen::Vector3d& metres) {
    std::string text = "[";
    for (int k = 0; k < 3; ++k)
        text += (k == 0 ? "" : ", ") + formatTomlNumber(mmFromMetres(metres[k]));
    return text + "]";
}

/// All six joints as nodes, and the centre O as a seventh at a height over their plane (mm): six legs, six
/// distances from it, nine projections about it: 21 equations for 21 unknowns.
std::string wholeHexapod(double centreOverPlane, const Pairs& pairs) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const Eigen::Vector3d centre =
        machine.p_OP_home_B + Eigen::Vector3d(0.0, 0.0, metresFromMm(centreOverPlane));
    std::string text =
        "format = 1\nname = \"whole\"\n[output]\nposition_mm = " + vectorText(machine.p_OP_home_B) + "\n";
    const auto name = [](const char* letter, int i) { return "\"" + (letter + std::to_string(i)) + "\""; };
    for (int i = 1; i <= kLegCount; ++i) {
        const Leg& leg = machine.legs[static_cast<std::size_t>(i - 1)];
        text += "[[fixed]]\nname = " + name("A", i) + "\nposition_mm = " + vectorText(leg.p_OA_B) + "\n";
        text += "[[node]]\nname = " + name("B", i) +
                "\nhome_mm = " + vectorText(machine.p_OP_home_B + leg.p_PB_P) + "\n";
        text += "[[actuator]]\nkind = \"ups\"\nname = " + name("l", i) + "\nbase = " + name("A", i) +
                "\nnode = " + name("B", i) + "\n";
        text += "[[rigid]]\nkind = \"distance\"\npoints = [" + name("B", i) + ", \"O\"]\n";
    }
    text += "[[node]]\nname = \"O\"\nhome_mm = " + vectorText(centre) + "\n";
    for (const auto& [i, j] : pairs)
        text += "[[projection]]\ncentre = \"O\"\npoints = [" + name("B", i) + ", " + name("B", j) + "]\n";
    return text;
}

Pairs withHexagon(const Pairs& more) {
    Pairs pairs = kHexagon;
    pairs.insert(pairs.end(), more.begin(), more.end());
    return pairs;
}

StepSystem systemOf(const std::string& toml) {
    return StepSystem(parseMechanism(toml, "test.toml"), "test.toml");
}

std::string refusal(const std::string& toml) {
    try {
        systemOf(toml);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(MechanismRank, NineUnknownsAreTheBestConditioned) {
    const StepSystem nine(nineUnknowns(laboratoryAtJoints()), "nine");
    EXPECT_EQ(nine.unknowns(), 9);
    EXPECT_LT(nine.homeCondition(), 4.6);
    const StepSystem whole = systemOf(wholeHexapod(-52.5, withHexagon({{1, 3}, {3, 5}, {5, 1}})));
    EXPECT_EQ(whole.unknowns(), 21);
    EXPECT_GT(whole.homeCondition(), 10.0 * nine.homeCondition());
}

/// Six points on a conic: the three diagonals say nothing that the hexagon does not. A solver that does not
/// look goes on, and the nodes come out 7 mm off.
TEST(MechanismRank, HexagonWithDiagonalsIsRefused) {
    const std::string said = refusal(wholeHexapod(-52.5, withHexagon({{1, 4}, {2, 5}, {3, 6}})));
    EXPECT_THAT(said, HasSubstr("test.toml: "));
    EXPECT_THAT(said, HasSubstr("21 equations of rank 20 at home"));
    EXPECT_THAT(said, HasSubstr("projection B3-B6 about O follows from"));
    EXPECT_THAT(said, HasSubstr("projection B1-B4 about O"));
    EXPECT_THAT(said, HasSubstr("projection B2-B5 about O"));
    EXPECT_EQ(said.find('\n'), std::string::npos);
}

TEST(MechanismRank, ACentreInThePlaneOfTheJointsIsRefused) {
    EXPECT_THAT(refusal(wholeHexapod(0.0, withHexagon({{1, 3}, {3, 5}, {5, 1}}))), HasSubstr("of rank"));
}

TEST(MechanismRank, SetsThatAreNotSquareAreRefused) {
    EXPECT_THAT(refusal(wholeHexapod(-52.5, kHexagon)),
                HasSubstr("18 equations for 21 unknowns: not square, rank 18 at home"));
    const std::string tooMany = refusal(wholeHexapod(-52.5, withHexagon({{1, 3}, {3, 5}, {5, 1}, {1, 4}})));
    EXPECT_THAT(tooMany, HasSubstr("22 equations for 21 unknowns: not square, rank 21 at home"));
    EXPECT_THAT(tooMany, HasSubstr("projection B1-B4 about O follows from"));
}

TEST(MechanismRank, ANodeThatNothingHoldsIsNamed) {
    std::string text = wholeHexapod(-52.5, withHexagon({{1, 3}, {3, 5}, {5, 1}}));
    text += "[[node]]\nname = \"loose\"\nhome_mm = [0, 0, 0]\n";
    for (const char* normal : {"[1, 0, 0]", "[0, 1, 0]", "[1, 1, 0]"})
        text += std::string("[[special]]\nkind = \"plane\"\npoint = \"loose\"\nnormal = ") + normal + "\n";
    const std::string said = refusal(text);
    EXPECT_THAT(said, HasSubstr("24 equations of rank 23"));
    EXPECT_THAT(said, HasSubstr("none holds z of loose"));
}

/// The whole system and the nine unknowns go the same way, and q is the same: it does not depend on the set.
TEST(MechanismRank, FullSetsGiveTheSamePath) {
    const StepSystem nine(nineUnknowns(laboratoryAtJoints()), "nine");
    const StepSystem whole = systemOf(wholeHexapod(-52.5, withHexagon({{1, 3}, {3, 5}, {5, 1}})));
    const LegLengths target = legLengths(laboratoryAtJoints(), kTarget2);
    constexpr int kSteps = 50;
    StepWorkspace nineMemory = nine.workspace(), wholeMemory = whole.workspace();
    Eigen::VectorXd nineNodes = nine.homeNodes(), wholeNodes = whole.homeNodes(), shift = wholeNodes;
    Eigen::VectorXd nineShift = nineNodes, from = nine.homeDrive();
    for (int k = 1; k <= kSteps; ++k) {
        const Eigen::VectorXd to = nine.homeDrive() + k * (target - nine.homeDrive()) / kSteps;
        nine.step(nineNodes, from, to, StepSide::Drive, nineMemory, nineShift);
        whole.step(wholeNodes, from, to, StepSide::Drive, wholeMemory, shift);
        nineNodes += nineShift;
        wholeNodes += shift;
        from = to;
    }
    for (int mark = 0; mark < 3; ++mark) // B1, B3, B5
        EXPECT_LT((nineNodes.segment<3>(3 * mark) - wholeNodes.segment<3>(6 * mark)).norm(), 1e-12);
}

} // namespace
} // namespace hexapose::testing::rank_test
