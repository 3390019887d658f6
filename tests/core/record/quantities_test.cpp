// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/record/quantities.h"
#include "tests/core/record/record_fixture.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>

namespace hexapose {
namespace {

using testing::EndsWith;

/// age_ms has one decimal, and no other text has fewer.
constexpr double kRounding = 0.051;

const Quantity& quantity(std::string_view name) {
    for (const Quantity& entry : quantities())
        if (entry.name == name)
            return entry;
    throw std::runtime_error("no quantity " + std::string(name));
}

TEST(Quantities, HaveNamesOfTheirOwnThatSayTheUnit) {
    std::set<std::string_view> names;
    for (const Quantity& entry : quantities()) {
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
        const std::string unit(entry.unit == "%" ? "percent" : entry.unit);
        EXPECT_THAT(std::string(entry.name), EndsWith(unit.empty() ? unit : "_" + unit));
    }
    EXPECT_EQ(quantities().front().name, "time_s");
    EXPECT_EQ(quantities().back().name, "event") << "what reads the log by place finds the events last";
}

TEST(Quantities, GiveTheNumberThatTheTextHolds) {
    const Snapshot s = fullSnapshot(3);
    int numbers = 0;
    for (const Quantity& entry : quantities()) {
        std::string text;
        entry.append(s, text);
        if (!entry.value)
            continue;
        const std::optional<double> value = entry.value(s);
        ASSERT_EQ(value.has_value(), !text.empty()) << entry.name;
        if (!value)
            continue;
        ++numbers;
        EXPECT_NEAR(parseNumber(text).value(), *value, entry.decimals < 0 ? 1e-9 : kRounding) << entry.name;
    }
    EXPECT_GT(numbers, 20);
    EXPECT_DOUBLE_EQ(quantity("l3_mm").value(s).value(), 336.6);
    EXPECT_DOUBLE_EQ(quantity("gamma_target_deg").value(s).value(), 5.0);
}

TEST(Quantities, KnowNothingOfAMeasurementThatIsOld) {
    Snapshot old = fullSnapshot();
    old.fresh = false;
    for (const char* name : {"l1_mm", "x_mm", "gamma_deg", "iterations", "residual_mm", "q"})
        EXPECT_FALSE(quantity(name).value(old).has_value()) << name;
}

TEST(Quantities, WriteNothingForWhatIsNoNumber) {
    Snapshot s = fullSnapshot();
    s.residual = std::numeric_limits<double>::infinity();
    s.determinantRatio = std::nan("");
    for (const char* name : {"residual_mm", "q"}) {
        std::string text;
        quantity(name).append(s, text);
        EXPECT_EQ(text, "") << name;
    }
}

} // namespace
} // namespace hexapose
