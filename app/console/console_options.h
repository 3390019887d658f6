// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/usage.h"
#include "core/motion/limits.h"
#include "core/record/log_options.h"
#include "core/session/connection.h"
#include "ui/common/theme.h"

#include <QString>
#include <QStringList>

#include <filesystem>
#include <optional>
#include <string>

namespace hexapose {

/// What the command line asks of the console.
struct ConsoleOptions {
    std::optional<ConnectionSpec> connection; ///< connect at once; empty: the operator does
    PlatformGeometry geometry;
    std::string method;                 ///< of kSolverChoices; empty: remembered, or the first of them
    PoseEnvelope envelope;              ///< no further from home
    std::filesystem::path logDirectory; ///< empty: the usual one
    LogOptions log;
    QString language; ///< empty: remembered, or the desktop's
    std::optional<ThemeKind> theme;
    bool headless = false;
    std::filesystem::path output; ///< of the headless run; empty: beside the log
    bool version = false;
};

/// What the console takes.
Usage consoleUsage();

/// Throws InputError "option: what is wrong" for anything that does not fit, and HelpRequest.
ConsoleOptions parseConsoleOptions(const QStringList& words);

/// Makes the directory when it is missing. Throws InputError "option dir: reason" unless files can be made in
/// it.
void requireWritable(const std::filesystem::path& directory, const std::string& option);

} // namespace hexapose
