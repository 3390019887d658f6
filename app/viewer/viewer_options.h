// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/usage.h"
#include "ui/common/theme.h"

#include <QString>
#include <QStringList>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hexapose {

/// What the command line asks of the viewer.
struct ViewerOptions {
    std::vector<std::filesystem::path> logs;
    std::filesystem::path exportFile; ///< empty: a window
    std::optional<double> from, to;   ///< s
    std::vector<std::string> charts;  ///< empty: all
    std::filesystem::path layout;     ///< empty: the usual one
    QString language;                 ///< empty: remembered, or the desktop's
    std::optional<ThemeKind> theme;
    bool version = false;
};

Usage viewerUsage();

/// Throws InputError "option: what is wrong" for anything that does not fit, and HelpRequest.
ViewerOptions parseViewerOptions(const QStringList& words);

} // namespace hexapose
