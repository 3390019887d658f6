// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table.h"
#include "ui/viewer/table_marks.h"

#include <filesystem>
#include <functional>
#include <string>

namespace hexapose {

/// A line of the file as it stands there, cut after some hundreds of letters. Throws InputError.
std::string textOfLine(const std::filesystem::path& file, const Table& table, long line);

/// The header and the rows of a span of time, as they stand in the file, bit by bit, in UTF-8; with the lines
/// between them that were left out of the table. Throws InputError, or what `write` throws.
void copyRows(const std::filesystem::path& file, const Table& table, const TimeSpan& span,
              const std::function<void(std::string_view)>& write);

} // namespace hexapose
