// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/common/arguments.h"

#include "app/common/directories.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/geometry/geometry_file.h"
#include "core/session/connection.h"
#include "core/table/gzip_file.h"

#include <QCommandLineOption>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

std::string dashed(std::string_view option) {
    return "--" + std::string(option);
}

/// Qt names the program alone, and no command.
std::string helpText(const QCommandLineParser& parser, const Usage& usage) {
    std::string text = "Usage: " + usage.call + " [options]";
    for (const QString& operand : usage.operands)
        text += " " + operand.toStdString();
    if (!usage.furtherOperands.isEmpty())
        text += " " + usage.furtherOperands.toStdString();
    const std::string rest = parser.helpText().toStdString();
    text += rest.substr(std::min(rest.find('\n'), rest.size()));
    if (!usage.remark.empty())
        text += "\n" + usage.remark + "\n";
    return text;
}

} // namespace

Arguments::Arguments(const Usage& usage, const QStringList& words) : m_subject(usage.subject()) {
    m_parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    m_parser.setApplicationDescription(QString::fromStdString(usage.about));
    for (const QString& operand : usage.operands)
        m_parser.addPositionalArgument(operand, QString());
    for (const OptionSpec& spec : usage.allOptions()) {
        QStringList names{QString::fromLatin1(spec.name)};
        if (names.front() == QLatin1String("help"))
            names.prepend(QStringLiteral("h"));
        m_parser.addOption(
            QCommandLineOption(names, QString::fromStdString(spec.help), QString::fromLatin1(spec.value)));
    }
    const bool parsed = m_parser.parse(QStringList{QString::fromStdString(usage.call)} + words);
    if (m_parser.isSet(QStringLiteral("help")))
        throw HelpRequest{helpText(m_parser, usage)};
    refuseMisfits(usage, parsed);
}

void Arguments::refuseMisfits(const Usage& usage, bool parsed) const {
    if (const QStringList unknown = m_parser.unknownOptionNames(); !unknown.isEmpty())
        throw InputError(dashed(unknown.front().toStdString()),
                         "unknown option; '" + usage.call + " --help' lists them");
    if (!parsed) { // "Missing value after '--port'."
        const QString text = m_parser.errorText();
        throw InputError(text.section(QLatin1Char('\''), 1, 1).toStdString(),
                         text.startsWith(QLatin1String("Missing")) ? "needs a value" : "takes no value");
    }
    QStringList found = m_parser.optionNames();
    found.sort();
    for (qsizetype i = 1; i < found.size(); ++i)
        if (found[i] == found[i - 1])
            throw InputError(dashed(found[i].toStdString()), "is given twice");
    for (const QString& name : found) {
        const QStringList values = m_parser.values(name);
        if (!values.isEmpty() && (values.front().isEmpty() || values.front().startsWith(QLatin1String("--"))))
            throw InputError(dashed(name.toStdString()), "needs a value");
    }
    const QStringList given = m_parser.positionalArguments();
    if (given.size() < usage.operands.size())
        throw InputError(m_subject, "missing " + usage.operands[given.size()].toStdString());
    if (given.size() > usage.operands.size() && usage.furtherOperands.isEmpty())
        throw InputError("'" + given[usage.operands.size()].toStdString() + "'",
                         "unexpected argument; '" + usage.call + " --help' lists what is taken");
}

std::string Arguments::operand(int index) const {
    return m_parser.positionalArguments().at(index).toStdString();
}

int Arguments::operandCount() const {
    return static_cast<int>(m_parser.positionalArguments().size());
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
        throw InputError(m_subject, "missing " + dashed(option));
    return value;
}

std::string Arguments::choice(const char* option, const std::vector<std::string>& known,
                              const char* fallback) const {
    std::string value = text(option, fallback);
    if (!has(option) || std::find(known.begin(), known.end(), value) != known.end())
        return value;
    std::string list;
    for (const std::string& word : known)
        list += (list.empty() ? "" : ", ") + word;
    throw InputError(dashed(option), "'" + value + "' is not known (known: " + list + ")");
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

double Arguments::number(const char* option, double fallback) const {
    if (!has(option))
        return fallback;
    const std::string value = text(option, "");
    const std::optional<double> number = parseNumber(value);
    if (!number || !std::isfinite(*number))
        throw InputError(dashed(option), "'" + value + "' is not a number");
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

int Arguments::baud() const {
    constexpr int kSlowest = 50;
    constexpr int kFastest = 12'000'000;
    return static_cast<int>(integer("baud", SerialConnection::kUsualBaud, kSlowest, kFastest));
}

PoseEnvelope Arguments::envelope() const {
    PoseEnvelope envelope;
    if (has("envelope-mm"))
        envelope.furthest.head<3>().setConstant(metresFromMm(requiredPositive("envelope-mm")));
    if (has("envelope-deg"))
        envelope.furthest.tail<3>().setConstant(radiansFromDeg(requiredPositive("envelope-deg")));
    return envelope;
}

LogOptions Arguments::logOptions() const {
    constexpr std::int64_t kBytes = 1'000'000; // of a megabyte
    constexpr std::int64_t kMost = 1'000'000;
    LogOptions options;
    options.partBytes = static_cast<std::uint64_t>(
        kBytes *
        integer("log-part-mb", static_cast<std::int64_t>(LogOptions::kPartBytes) / kBytes, 1, kMost));
    if (has("log-gzip"))
        options.compress = gzipFile;
    return options;
}

} // namespace hexapose
