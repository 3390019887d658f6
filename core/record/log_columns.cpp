// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/log_columns.h"

#include "core/record/quantities.h"

namespace hexapose {

std::string logHeader() {
    std::string line;
    for (const Quantity& quantity : quantities()) {
        line += quantity.name;
        line += ',';
    }
    line.back() = '\n';
    return line;
}

void appendLogRow(const Snapshot& snapshot, std::string& buffer) {
    for (const Quantity& quantity : quantities()) {
        quantity.append(snapshot, buffer);
        buffer += ',';
    }
    buffer.back() = '\n';
}

} // namespace hexapose
