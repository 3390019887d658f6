// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/platform_geometry.h"

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace hexapose {

/// An option of a command: `--name VALUE`, or a switch when `value` is empty.
struct OptionSpec {
    const char* name;
    const char* value;
    const char* help;
};

/// The words of one command, parsed. Anything that does not fit is an InputError that names the option.
class Arguments {
public:
    /// operands: the names of the positional arguments, all of them required. --platform and --help are
    /// always taken.
    Arguments(const char* command, const QStringList& operands, const std::vector<OptionSpec>& options,
              const QStringList& arguments);

    std::string operand(int index) const;
    bool has(const char* option) const;
    std::string text(const char* option, const char* fallback) const;
    std::string requiredText(const char* option) const;
    /// A finite number above zero.
    double positive(const char* option, double fallback) const;
    double requiredPositive(const char* option) const;
    std::int64_t integer(const char* option, std::int64_t fallback, std::int64_t least,
                         std::int64_t most) const;
    /// The platform of --platform, or the laboratory platform.
    PlatformGeometry platform() const;

private:
    QCommandLineParser m_parser;
    QString m_command;
};

/// For the files of a command, with its parents. Throws InputError when it cannot be made.
void makeDirectory(const std::filesystem::path& directory);

} // namespace hexapose
