// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace hexapose {

/// Where the words of reports are translated: into the language of the window, English without one.
struct ReportWords {
    Q_DECLARE_TR_FUNCTIONS(hexapose::ReportWords)
};

} // namespace hexapose
