// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/measurements.h"
#include "ui/plot/picture.h"

namespace hexapose::reproduce {

/// Figure 5: (a) log10 D(X) and (b) iterations, over log10 D(L).
Picture stopPicture(const std::vector<StopMeasurement>& table);
/// What the measured values of Table 4 differ from the published ones, in percent.
Picture stopDeviationPicture(const std::vector<StopMeasurement>& table);

} // namespace hexapose::reproduce
