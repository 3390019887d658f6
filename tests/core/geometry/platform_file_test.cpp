// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/geometry/geometry_file.h"

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

using namespace hexapose;

namespace {

const std::string kLaboratory = std::string(HEXAPOSE_SOURCE_DIR) + "/resources/platforms/laboratory.toml";

/// A file whose lines the tests know: leg k begins in line 6 k - 1.
std::string goodText() {
    std::string text = "format = 1\nname = \"Test\"\n[home]\nposition_mm = [0, 0.0, 300]\n";
    const char* joints[6][2] = {{"[-25, 184, 0]", "[-84, 74, 0]"},     {"[25, 184, 0]", "[84, 74, 0]"},
                                {"[172, -70, 0]", "[107, 36, 0]"},     {"[147, -114, 0]", "[23, -110, 0]"},
                                {"[-147, -114, 0]", "[-23, -110, 0]"}, {"[-172, -70, 0]", "[-107, 36, 0]"}};
    for (const auto& leg : joints)
        text += std::string("[[leg]]\nbase_mm = ") + leg[0] + "\nplatform_mm = " + leg[1] +
                "\nmin_mm = 250\nmax_mm = 400.5\n\n";
    return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

std::string complaintOf(const std::string& text) {
    try {
        parsePlatform(text, "file.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

void expectSame(const PlatformGeometry& a, const PlatformGeometry& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.p_OP_home_B, b.p_OP_home_B);
    for (std::size_t i = 0; i < kLegCount; ++i) {
        EXPECT_EQ(a.legs[i].p_OA_B, b.legs[i].p_OA_B);
        EXPECT_EQ(a.legs[i].p_PB_P, b.legs[i].p_PB_P);
        EXPECT_EQ(a.legs[i].minLength, b.legs[i].minLength);
        EXPECT_EQ(a.legs[i].maxLength, b.legs[i].maxLength);
    }
}

} // namespace

TEST(PlatformFile, NamesTheLikelyCauseOfLengthsOutsideTheirStrokes) {
    const PlatformGeometry laboratory = loadPlatform(kLaboratory);
    const auto after = [&](const std::function<void(PlatformGeometry&)>& spoil) {
        PlatformGeometry geometry = laboratory;
        spoil(geometry);
        const std::string complaint = complaintOf(formatPlatform(geometry));
        const std::string before = "; likely cause: ";
        const std::size_t at = complaint.find(before);
        return at == std::string::npos ? complaint : complaint.substr(at + before.size());
    };
    EXPECT_EQ(after([](PlatformGeometry& g) {
                  for (Leg& leg : g.legs)
                      leg.p_PB_P += g.p_OP_home_B;
              }),
              "platform_mm is given in the base frame, not from the platform's origin");
    EXPECT_EQ(after([](PlatformGeometry& g) {
                  const auto legs = g.legs;
                  for (std::size_t i = 0; i < kLegCount; ++i)
                      g.legs[(i + 1) % kLegCount].p_PB_P = legs[i].p_PB_P;
                  for (Leg& leg : g.legs) { // closer than those of the file, which leave room for this
                      leg.minLength = 0.290;
                      leg.maxLength = 0.310;
                  }
              }),
              "platform_mm of each leg belongs to the leg before");
    EXPECT_EQ(after([](PlatformGeometry& g) {
                  for (Leg& leg : g.legs) {
                      leg.minLength /= 25.4;
                      leg.maxLength /= 25.4;
                  }
              }),
              "min_mm and max_mm are in inches");
    EXPECT_EQ(after([](PlatformGeometry& g) {
                  g.p_OP_home_B /= 1000.0;
                  for (Leg& leg : g.legs) {
                      leg.p_OA_B /= 1000.0;
                      leg.p_PB_P /= 1000.0;
                  }
              }),
              "base_mm, platform_mm and position_mm are in metres");
    // A wrong stroke alone has none.
    EXPECT_EQ(after([](PlatformGeometry& g) { g.legs[2].maxLength = 0.260; }).find("likely"),
              std::string::npos);
    EXPECT_EQ(after([](PlatformGeometry&) {}), "accepted");
}

TEST(PlatformFile, LaboratoryHasThePublishedHomeLengths) {
    const PlatformGeometry laboratory = loadPlatform(kLaboratory);
    LegLengths published;
    published << 299.9150, 299.9150, 299.9168, 299.9177, 299.9177, 299.9168;
    EXPECT_LT((laboratory.homeLengths() * 1000.0 - published).cwiseAbs().maxCoeff(), 5e-5);
    EXPECT_NEAR(laboratory.size(), 0.2999165, 1e-7);
    EXPECT_NEAR(laboratory.jointRadius(), std::hypot(0.112276, 0.0525), 1e-6);
    EXPECT_EQ(laboratory.legs[3].p_OA_B,
              Eigen::Vector3d(metresFromMm(146.85), metresFromMm(-113.65), metresFromMm(52.5)));
    EXPECT_TRUE(validate(laboratory).empty());
}

TEST(PlatformFile, ComesBackFromItsOwnTextExactly) {
    expectSame(parsePlatform(formatPlatform(loadPlatform(kLaboratory)), "copy"), loadPlatform(kLaboratory));
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> shift(-1.0, 1.0);
    for (int k = 0; k < 300; ++k) { // whatever a file can hold
        PlatformGeometry geometry = loadPlatform(kLaboratory);
        const auto jitter = [&](double& metres) {
            metres = metresFromMm(mmFromMetres(metres) + shift(random));
        };
        for (Leg& leg : geometry.legs) {
            jitter(leg.p_OA_B[k % 3]);
            jitter(leg.p_PB_P[k % 3]);
            jitter(leg.maxLength);
        }
        jitter(geometry.p_OP_home_B[2]);
        expectSame(parsePlatform(formatPlatform(geometry), "copy"), geometry);
    }
    PlatformGeometry named = loadPlatform(kLaboratory);
    named.name = "a \"quoted\" \\ name, 六自由度";
    expectSame(parsePlatform(formatPlatform(named), "copy"), named);
}

TEST(PlatformFile, TellsWhatIsWrongAndWhere) {
    const struct {
        const char *what, *by, *complaint;
    } cases[] = {
        {"format = 1\n", "\n", "file.toml:1: missing key \"format\""},
        {"format = 1\n", "format = 2\n", "file.toml:1: unknown format 2, expected 1"},
        {"format = 1\n", "format = 1.0\n", "file.toml:1: format is a decimal number, not an integer"},
        {"name = \"Test\"", "name = 5", "file.toml:2: name is an integer, not text"},
        {"name = \"Test\"", "name = \"a\\nb\"",
         "file.toml:2: name holds a line break or another control character"},
        {"name = \"Test\"", "", "file.toml:1: missing key \"name\""},
        {"name = \"Test\"", "name = \"Test\" colour", "file.toml:2: "},
        {"name = \"Test\"", "name = \"Test\"; colour = 1", "file.toml:2: "},
        {"[home]", "colour = 1\n[home]", "file.toml:3: unknown key \"colour\""},
        {"[0, 0.0, 300]", "[0, 0.0, 300]\nspeed = 1", "file.toml:5: home: unknown key \"speed\""},
        {"[0, 0.0, 300]", "[0, 0.0]", "file.toml:4: home: position_mm has 2 numbers, expected 3"},
        {"[0, 0.0, 300]", "[0, 0.0, inf]", "file.toml:4: home: position_mm[2] is inf, not a finite number"},
        {"[0, 0.0, 300]", "300", "file.toml:4: home: position_mm is an integer, not a list of three numbers"},
        {"[home]\nposition_mm = [0, 0.0, 300]", "home = 3\n", "file.toml:3: home is an integer, not a table"},
        {"min_mm = 250", "min_mm = 250\nmid_mm = 3", "file.toml:9: leg 1: unknown key \"mid_mm\""},
        {"min_mm = 250", "", "file.toml:5: leg 1: missing key \"min_mm\""},
        {"min_mm = 250", "min_mm = \"250\"", "file.toml:8: leg 1: min_mm is text, not a number"},
        {"min_mm = 250", "min_mm = nan", "file.toml:8: leg 1: min_mm is nan, not a finite number"},
        {"min_mm = 250", "min_mm = 450", "file.toml:8: leg 1: min_mm 450 is not below max_mm 400.5"},
        {"min_mm = 250", "min_mm = 0", "file.toml:8: leg 1: min_mm 0 is not above 0"},
        {"min_mm = 250", "min_mm = 340",
         "file.toml:8: leg 1: length at home 324.932301 mm is below min_mm 340"},
        {"[172, -70, 0]", "[172, -70, -200]", "file.toml:21: leg 3: length at home 515."},
        {"[172, -70, 0]", "[172, -70, 1e308]",
         "file.toml:18: leg 3: length at home inf mm is not a positive number"},
        {"[25, 184, 0]", "[25, true, 0]", "file.toml:12: leg 2: base_mm[1] is true or false, not a number"},
        {"[25, 184, 0]\nplatform_mm = [84, 74, 0]", "[-25, 184, 0]\nplatform_mm = [-84, 74, 0]",
         "file.toml:12: leg 2: coincident joints, base_mm and platform_mm are those of leg 1"},
        {"[25, 184, 0]", "[25, 184, 0", "file.toml:13: "},
    };
    for (const auto& c : cases) {
        const std::string complaint = complaintOf(replaced(goodText(), c.what, c.by));
        EXPECT_EQ(complaint.rfind(c.complaint, 0), 0U) << c.by << " gave: " << complaint;
        EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
    }
    EXPECT_EQ(complaintOf(goodText()), "accepted");
}

TEST(PlatformFile, CountsTheLegs) {
    const std::string text = goodText();
    const std::string five = text.substr(0, text.rfind("[[leg]]"));
    EXPECT_EQ(complaintOf(five), "file.toml:29: expected 6 legs, found 5");
    EXPECT_EQ(complaintOf(text + text.substr(text.rfind("[[leg]]"))),
              "file.toml:41: expected 6 legs, found 7");
    EXPECT_EQ(complaintOf("format = 1\nname = \"\"\nleg = []\n[home]\nposition_mm = [0,0,1]\n"),
              "file.toml:3: expected 6 legs, found 0");
    EXPECT_EQ(complaintOf("format = 1\nname = \"\"\nleg = 6\n[home]\nposition_mm = [0,0,1]\n"),
              "file.toml:3: leg is an integer, not six [[leg]] tables");
}

TEST(PlatformFile, RefusesJointsOnOneLineOrPoint) {
    PlatformGeometry line = loadPlatform(kLaboratory), point = line;
    for (std::size_t i = 0; i < kLegCount; ++i) {
        line.legs[i].p_PB_P = Eigen::Vector3d(0.02, 0.01, 0.0525) * (1.0 + 0.1 * static_cast<double>(i));
        point.legs[i].p_PB_P = Eigen::Vector3d(0.0, 0.0, 0.0525);
        line.legs[i].minLength = point.legs[i].minLength = 0.1;
        line.legs[i].maxLength = point.legs[i].maxLength = 0.6;
    }
    EXPECT_EQ(complaintOf(formatPlatform(line)).find("all platform joints lie on one line") !=
                  std::string::npos,
              true);
    EXPECT_EQ(complaintOf(formatPlatform(point)).find("all platform joints are one point") !=
                  std::string::npos,
              true);
}

TEST(PlatformFile, AcceptsLegsThatShareOneJoint) {
    // 3-3 octahedral: each joint belongs to two legs.
    PlatformGeometry octahedron = loadPlatform(kLaboratory);
    for (std::size_t i = 0; i < kLegCount; ++i) {
        const double base = 2.0 * static_cast<double>(((i + 1) / 2) % 3),
                     top = 2.0 * static_cast<double>(i / 2) + 1.0;
        octahedron.legs[i].p_OA_B = 0.2 * Eigen::Vector3d(std::cos(base), std::sin(base), 0.0);
        octahedron.legs[i].p_PB_P = 0.1 * Eigen::Vector3d(std::cos(top), std::sin(top), 0.0);
        octahedron.legs[i].minLength = 0.1;
        octahedron.legs[i].maxLength = 0.6;
    }
    EXPECT_EQ(complaintOf(formatPlatform(octahedron)), "accepted");
}

TEST(PlatformFile, NamesAFileThatCannotBeRead) {
    for (const std::string& name : {std::string("/no/such/file.toml"), std::string("/")})
        try {
            loadPlatform(name);
            FAIL();
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()), name + ": cannot be read");
        }
}

TEST(PlatformGeometry, FingerprintFollowsTheKinematicsOnly) {
    const PlatformGeometry laboratory = loadPlatform(kLaboratory);
    PlatformGeometry other = laboratory;
    other.name = "other";
    other.legs[2].maxLength = 0.4;
    EXPECT_EQ(other.fingerprint(), laboratory.fingerprint());
    EXPECT_EQ(laboratory.fingerprint().size(), 16U);
    other.legs[5].p_PB_P[1] = std::nextafter(other.legs[5].p_PB_P[1], 1.0);
    EXPECT_NE(other.fingerprint(), laboratory.fingerprint());
}

TEST(PlatformGeometry, ValidationListsEverything) {
    PlatformGeometry bad = loadPlatform(kLaboratory);
    bad.legs[1].minLength = 0.31;
    bad.legs[4].maxLength = -1.0;
    const auto faults = validate(bad);
    ASSERT_EQ(faults.size(), 2U);
    EXPECT_EQ(faults[0].rfind("leg 2: length at home 299.9", 0), 0U) << faults[0];
    EXPECT_EQ(faults[1], "leg 5: min_mm 250 is not below max_mm -1000");
    bad.legs[0].p_OA_B[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(validate(bad).front(), "leg 1: base_mm[0] is nan, not a finite number");
}
