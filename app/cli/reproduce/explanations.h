// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What has to be known to read the paper's numbers; said on the screen and on paper.
namespace hexapose::reproduce {

inline constexpr const char* kWhyLinear =
    "Why the published Newton is linear: its Jacobian holds the joint vectors unrotated (b x n where R b x n "
    "belongs), the angular velocity omega is added to the Euler angles as if it were their rate, and the "
    "error "
    "is tested before the update, which is applied all the same. Such an iteration takes the same part off "
    "the "
    "error each time, 1.39 iterations a decade. With the exact Jacobian Newton squares the error instead, "
    "and "
    "stops where the test is met.";

inline constexpr const char* kTable3Misprint = "Misprint in Table 3: its first row (Newton, set 1: 3.2 2.7 "
                                               "12.5 3.2 3.0 1.4 e-5) disagrees with the first "
                                               "row of Table 2 (0.3 0.2 1.7 0.4 0.4 0.2 e-5), which is the "
                                               "same method on the same poses in the same time. "
                                               "Table 2 is the reproducible one.";

inline constexpr const char* kTable5Misprint = "Misprint in Table 5: the published gamma, 0.0896, is a "
                                               "misprint of 0.0869: two digits are exchanged. Its "
                                               "reference, 5 deg, is 0.08727 rad, not 0.0870.";

inline constexpr const char* kFewDigits = "Where the paper prints one digit, most of a deviation may be its "
                                          "rounding: 0.2 stands for all from 0.15 to "
                                          "0.25.";

inline constexpr const char* kOneStepMore = "Some errors are larger with the exact Jacobian: it stops as "
                                            "soon as the test of 1e-3 m is met, in far fewer "
                                            "iterations, where the published iteration takes one more step.";

inline constexpr const char* kColumns =
    "published: as printed. measured: the iteration as published. exact (Jacobian): Newton with the exact "
    "derivative and the same stop test in the place of the published iteration.";

} // namespace hexapose::reproduce
