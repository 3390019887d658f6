// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/exhibit.h"

#include <filesystem>

namespace hexapose::reproduce {

/// NAME.txt, NAME.csv, NAME.png and NAME.svg, the same on every run, and NAME-times.csv, .png and .svg where
/// there are times. Throws InputError when one cannot be written.
void writeExhibit(const Exhibit& exhibit, const std::filesystem::path& directory);

} // namespace hexapose::reproduce
