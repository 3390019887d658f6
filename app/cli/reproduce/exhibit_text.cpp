// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/exhibit_text.h"

#include "app/cli/reproduce/printed.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <sstream>

namespace hexapose::reproduce {

namespace {

constexpr std::size_t kGap = 2;
constexpr std::size_t kFewChecks = 6;
constexpr int kCheckDigits = 5;

std::string wrapped(const std::string& paragraph) {
    std::istringstream words(paragraph);
    std::string text, line;
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 1 + word.size() > kTextColumns) {
            text += line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return text + line + "\n";
}

using Widths = std::vector<std::size_t>;

Widths columnWidths(const Block& block) {
    Widths widths(block.header.size());
    const auto widen = [&](const std::vector<std::string>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i)
            widths[i] = std::max(widths[i], cells[i].size());
    };
    widen(block.header);
    for (const Block::Row& row : block.rows)
        if (!row.heading)
            widen(row.cells);
    return widths;
}

std::string trimmed(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

std::string rowText(const std::vector<std::string>& cells, const Widths& widths) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string padding(widths[i] - cells[i].size(), ' ');
        line += i == 0 ? cells[i] + padding : std::string(kGap, ' ') + padding + cells[i];
    }
    return trimmed(line);
}

/// Each name in the middle of a line of dashes over its columns.
std::string groupText(const Block& block, const Widths& widths) {
    std::string line(widths.front(), ' ');
    std::size_t column = 1;
    for (const Block::Group& group : block.groups) {
        std::size_t room = 0;
        for (int i = 0; i < group.columns; ++i)
            room += kGap + widths[column++];
        const std::string name = group.name.empty() ? "" : " " + group.name + " ";
        const std::size_t dashes = room - kGap - std::min(room - kGap, name.size());
        const char dash = group.name.empty() ? ' ' : '-';
        line += std::string(kGap, ' ') + std::string(dashes / 2, dash) + name +
                std::string(dashes - dashes / 2, dash);
    }
    return trimmed(line);
}

std::string blockText(const Block& block) {
    const Widths widths = columnWidths(block);
    std::string text;
    if (!block.groups.empty())
        text += groupText(block, widths);
    text += rowText(block.header, widths);
    for (const Block::Row& row : block.rows)
        text += row.heading ? row.cells.front() + "\n" : rowText(row.cells, widths);
    return text + "\n";
}

} // namespace

std::string exhibitText(const Exhibit& exhibit) {
    std::string text = exhibit.title + "\n\n" + wrapped(exhibit.what) + "\n";
    for (const Block& block : exhibit.blocks)
        text += blockText(block);
    for (const std::string& note : exhibit.notes)
        text += wrapped(note) + "\n";
    if (!exhibit.checks.empty())
        text += wrapped(checksText(exhibit)) + "\n";
    if (const std::optional<Block> checks = checksBlock(exhibit))
        text += blockText(*checks);
    return text.substr(0, text.size() - 1); // the blank line after the last part
}

std::string timesText(const Exhibit& exhibit) {
    if (exhibit.times.empty())
        return {};
    std::string text = "\n" + wrapped(exhibit.aboutTimes) + "\n";
    for (const Block& block : exhibit.times)
        text += blockText(block);
    return text.substr(0, text.size() - 1);
}

std::optional<Block> checksBlock(const Exhibit& exhibit) {
    if (exhibit.checks.empty() || exhibit.checks.size() > kFewChecks)
        return std::nullopt;
    Block block;
    block.header = {"checked", "expected", "measured", "deviation", "allowed", ""};
    for (const Check& check : exhibit.checks) {
        const double part = check.expected == 0.0 ? 0.0 : 100.0 * check.allowed / check.expected;
        block.rows.push_back(
            {{check.what, inDigits(check.expected, kCheckDigits), inDigits(check.measured, kCheckDigits),
              deviationText(check.measured, check.expected, 1),
              part == 0.0 ? "" : formatFixed(part, 0) + " %", check.holds() ? "holds" : "deviates"}});
    }
    return block;
}

std::string checksText(const Exhibit& exhibit) {
    if (exhibit.checks.empty())
        return {};
    return "Checks: " + std::to_string(holding(exhibit.checks)) + " of " +
           std::to_string(exhibit.checks.size()) + " hold (" + exhibit.checkRule + ").";
}

} // namespace hexapose::reproduce
