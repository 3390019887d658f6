// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/measurements.h"
#include "ui/plot/picture.h"

namespace hexapose::reproduce {

/// A column of panels for each algorithm, one panel a set; with iterations, their totals below.
Picture errorPicture(const std::vector<ErrorMeasurement>& table, bool withIterations);

} // namespace hexapose::reproduce
