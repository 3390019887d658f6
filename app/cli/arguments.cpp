// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/arguments.h"

#include "app/common/directories.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/geometry/geometry_file.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace hexapose {

namespace {

std::string dashed(const char* option) {
    return std::string("--") + option;
}

} // namespace

Arguments::Arguments(const char* command, const QStringList& operands, const std::vector<OptionSpec>& options,
                     const QStringList& arguments)
    : m_command(QString::fromLatin1(command)) {
    m_parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    for (const QString& operand : operands)
        m_parser.addPositionalArgument(operand, QString());
    for (const OptionSpec& spec : options)
        m_parser.addOption(QCommandLineOption(QString::fromLatin1(spec.name), QString::fromUtf8(spec.help),
                                              QString::fromLatin1(spec.value)));
    m_parser.addOption(QCommandLineOption(QStringLiteral("platform"),
                                          QStringLiteral("Platform name or file (default: laboratory)."),
                                          QStringLiteral("NAME|FILE")));
    m_parser.addHelpOption();
    const QString program = QStringLiteral("hexapose-cli ") + m_command;
    if (!m_parser.parse(QStringList{program} + arguments))
        throw InputError(command, m_parser.errorText().trimmed().toStdString());
    if (m_parser.isSet(QStringLiteral("help"))) {
        std::fputs(m_parser.helpText().toUtf8().constData(), stdout);
        std::exit(0);
    }
    QStringList found = m_parser.optionNames();
    found.sort();
    for (qsizetype i = 1; i < found.size(); ++i)
        if (found[i] == found[i - 1])
            throw InputError(command, "--" + found[i].toStdString() + " is given twice");
    const QStringList given = m_parser.positionalArguments();
    if (given.size() < operands.size())
        throw InputError(command, "missing " + operands[given.size()].toStdString());
    if (given.size() > operands.size())
        throw InputError(command, "unexpected argument '" + given[operands.size()].toStdString() + "'");
}

std::string Arguments::operand(int index) const {
    return m_parser.positionalArguments().at(index).toStdString();
}

bool Arguments::has(const char* option) const {
    return m_parser.isSet(QString::fromLatin1(option));
}

std::string Arguments::text(const char* option, const char* fallback) const {
    return has(option) ? m_parser.value(QString::fromLatin1(option)).toStdString() : std::string(fallback);
}

std::string Arguments::requiredText(const char* option) const {
    const std::string value = text(option, "");
    if (value.empty())
        throw InputError(m_command.toStdString(), "missing " + dashed(option));
    return value;
}

double Arguments::positive(const char* option, double fallback) const {
    if (!has(option))
        return fallback;
    const std::string value = text(option, "");
    const std::optional<double> number = parseNumber(value);
    if (!number || !std::isfinite(*number) || *number <= 0.0)
        throw InputError(dashed(option), "'" + value + "' is not a number above 0");
    return *number;
}

double Arguments::requiredPositive(const char* option) const {
    requiredText(option);
    return positive(option, 0.0);
}

std::int64_t Arguments::integer(const char* option, std::int64_t fallback, std::int64_t least,
                                std::int64_t most) const {
    if (!has(option))
        return fallback;
    const std::string value = text(option, "");
    const std::optional<long long> number = parseInteger(value);
    if (!number || *number < least || *number > most)
        throw InputError(dashed(option), "'" + value + "' is not a whole number from " +
                                             std::to_string(least) + " to " + std::to_string(most));
    return *number;
}

PlatformGeometry Arguments::platform() const {
    return loadPlatform(findPlatformFile(text("platform", "laboratory")));
}

void makeDirectory(const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
        throw InputError(directory.string(), "cannot be made: " + error.message());
}

} // namespace hexapose
