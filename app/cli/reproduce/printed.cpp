// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/printed.h"

#include "core/base/number_text.h"
#include "ui/report/report_numbers.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace hexapose::reproduce {

Printed printed(const char* digits, int exponent) {
    const std::string_view text(digits);
    const std::size_t point = text.find('.');
    const int decimals = point == std::string_view::npos ? 0 : static_cast<int>(text.size() - point - 1);
    const std::string number = std::string(text) + "e" + std::to_string(exponent);
    return {parseNumber(number).value_or(std::nan("")), std::pow(10.0, exponent - decimals), decimals};
}

const char* title(published::Algorithm algorithm) {
    constexpr std::array<const char*, 5> kTitles{"Newton", "MPR2", "MPR3", "MPR2-NR", "MPR3-NR"};
    return kTitles[static_cast<std::size_t>(algorithm)];
}

std::string title(const published::ErrorRow& row) {
    return std::string(title(row.algorithm)) + ", set " + std::to_string(row.set);
}

std::string inDigits(double value, int digits) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
    return {text.data(), end};
}

std::string threeDigits(double value) {
    return errorText(value).toStdString();
}

std::string deviationText(double measured, double published, int decimals) {
    if (published == 0.0)
        return {};
    const std::string text = formatFixed(100.0 * (measured / published - 1.0), decimals);
    return (text.front() == '-' ? "" : "+") + text + " %";
}

std::string csvLine(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) {
        line += line.empty() ? "" : ",";
        line += field;
    }
    line += "\n";
    return line;
}

} // namespace hexapose::reproduce
