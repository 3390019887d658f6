// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/checks.h"
#include "ui/plot/picture.h"

#include <optional>
#include <string>
#include <vector>

namespace hexapose::reproduce {

/// A table of text: the first column is set left, the others right.
struct Block {
    struct Group {
        std::string name;
        int columns;
    };
    std::vector<Group> groups; ///< names over the columns after the first; none: no such line
    std::vector<std::string> header;
    struct Row {
        std::vector<std::string> cells;
        bool heading = false; ///< one cell, over what follows
    };
    std::vector<Row> rows;
};

/// A published table or figure beside its measurement, as it is shown and written.
struct Exhibit {
    std::string name;  ///< "table2"
    std::string title; ///< "Table 2: ..."
    std::string what;  ///< what is shown and in which units, one paragraph
    std::vector<Block> blocks;
    std::vector<std::string> notes; ///< paragraphs
    std::string checkRule;          ///< what is checked; "" when nothing is
    std::vector<Check> checks;
    std::string csv;
    Picture picture;
    /// Seconds, which no run repeats: kept out of all that does.
    std::vector<Block> times;
    std::string timesCsv;
    std::string aboutTimes; ///< said where they are shown
    std::optional<Picture> timesPicture;
};

} // namespace hexapose::reproduce
