// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/snapshot.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// What belongs together on a chart or in a message.
enum class QuantityGroup {
    Time,
    Length,   ///< measured
    SetPoint, ///< of the legs
    Target,   ///< where the motion ends
    Pose,     ///< measured
    Solution,
    State,
    Link,
    Path, ///< where the platform should be now
    Motion,
    FollowingError,
    Event,
};

/// One thing that a snapshot knows, under the name by which files know it.
struct Quantity {
    static constexpr int kShortest = -1;

    std::string_view name; ///< the log's column, its unit included: "l1_mm"
    std::string_view unit; ///< "s", "ms", "us", "mm", "deg", "%"; empty: a pure number, or words
    QuantityGroup group;
    int decimals; ///< of the text; kShortest: the shortest text that reads back to the same double
    /// In that unit; nothing while it is not known. Null: the quantity is words.
    std::optional<double> (*value)(const Snapshot& snapshot);
    /// Appends its text, nothing while it is not known. Null: the value with those decimals.
    void (*text)(const Snapshot& snapshot, std::string& line) = nullptr;

    void append(const Snapshot& snapshot, std::string& line) const;
};

/// All of them, in the order of the log's columns; resources/manual/files.md says what each holds. What is
/// measured is known only in a cycle with a fresh measurement.
const std::vector<Quantity>& quantities();

} // namespace hexapose
