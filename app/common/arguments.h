// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/usage.h"
#include "core/geometry/platform_geometry.h"
#include "core/motion/limits.h"
#include "core/record/log_options.h"

#include <QCommandLineParser>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// Thrown when --help is among the words; the text is for standard output.
struct HelpRequest {
    std::string text;
};

/// The words after a program's or a command's name, parsed. Anything that does not fit is an InputError that
/// names the option. A number is understood whole, or refused.
class Arguments {
public:
    Arguments(const Usage& usage, const QStringList& words);

    std::string operand(int index) const;
    int operandCount() const;
    bool has(const char* option) const;
    std::string text(const char* option, const char* fallback) const;
    std::string requiredText(const char* option) const;
    /// One of these words; `fallback` when the option is not given.
    std::string choice(const char* option, const std::vector<std::string>& known, const char* fallback) const;
    /// A finite number above zero.
    double positive(const char* option, double fallback) const;
    /// Any finite number.
    double number(const char* option, double fallback) const;
    double requiredPositive(const char* option) const;
    std::int64_t integer(const char* option, std::int64_t fallback, std::int64_t least,
                         std::int64_t most) const;
    /// The platform of --platform, or the laboratory platform.
    PlatformGeometry platform() const;
    /// Of --baud.
    int baud() const;
    /// Of --envelope-mm and --envelope-deg.
    PoseEnvelope envelope() const;
    /// Of --log-part-mb and --log-gzip.
    LogOptions logOptions() const;

private:
    void refuseMisfits(const Usage& usage, bool parsed) const;

    QCommandLineParser m_parser;
    std::string m_subject;
};

} // namespace hexapose
