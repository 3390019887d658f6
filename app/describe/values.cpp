// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/describe/values.h"

#include "app/common/directories.h"

namespace hexapose {

namespace {

bool isWord(const QString& alternative) {
    return !alternative.isEmpty() && !alternative[0].isUpper();
}

/// As OptionSpec::value says.
void addValues(Values& values, const QString& form) {
    for (QString alternative : form.split(QLatin1Char('|'))) {
        if (alternative.endsWith(QLatin1String("..."))) // one or more
            alternative.chop(3);
        const qsizetype dot = alternative.indexOf(QLatin1Char('.'));
        if (isWord(alternative)) {
            values.words.push_back(alternative.toStdString());
        } else if (alternative == QLatin1String("DIR")) {
            values.directories = true;
        } else if (alternative == QLatin1String("FILE") || alternative == QLatin1String("PATH") || dot > 0) {
            values.files = true;
            values.suffix = dot > 0 ? alternative.mid(dot).toStdString() : std::string();
        }
    }
}

} // namespace

Values valuesOf(const OptionSpec& option) {
    Values values;
    values.words = option.words;
    const QString form = QString::fromLatin1(option.value);
    if (form.split(QLatin1Char('|')).contains(QLatin1String("NAME"))) // "platform": of the folder platforms
        values.words = shippedNames(std::string(option.name) + "s");
    addValues(values, form);
    return values;
}

Values valuesOf(const QStringList& operands) {
    Values values;
    for (const QString& operand : operands)
        addValues(values, operand);
    return values;
}

} // namespace hexapose
