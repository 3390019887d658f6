// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/exhibits.h"

namespace hexapose::reproduce {

const std::vector<ExhibitMaker>& exhibitMakers() {
    static const std::vector<ExhibitMaker> makers{
        {"table2", makeTable2},     {"table3", makeTable3},     {"table4", makeTable4},
        {"table5", makeTable5},     {"figure3", makeFigure3},   {"figure5", makeFigure5},
        {"figure13", makeFigure13}, {"figure15", makeFigure15}, {"figure16", makeFigure16}};
    return makers;
}

} // namespace hexapose::reproduce
