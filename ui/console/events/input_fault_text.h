// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/input_error.h"

#include <QString>

namespace hexapose {

/// "list.csv:3: the last line is incomplete": what() of the error, in the language of the window.
QString inputFaultText(const InputError& error);

} // namespace hexapose
