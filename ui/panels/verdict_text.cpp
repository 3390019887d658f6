// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/verdict_text.h"

#include "core/geometry/number_text.h"
#include "core/geometry/units.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>

namespace hexapose {

namespace {

struct VerdictText {
    Q_DECLARE_TR_FUNCTIONS(hexapose::VerdictText)
};

QString number(double value, int decimals) {
    return QString::fromStdString(formatFixed(value, decimals));
}

QString legText(const Verdict& verdict) {
    const double value = mmFromMetres(verdict.value);
    const double bound = mmFromMetres(verdict.bound);
    const double by = std::abs(value - bound);
    // A tenth tells enough, unless it would read "by 0.0 mm".
    const int decimals = by < 0.1 ? 4 : 1;
    const QString text = verdict.reason == Verdict::Reason::LegAboveMax
                             ? VerdictText::tr("Leg %1 would be %2 mm, above its maximum %3 mm (by %4 mm)")
                             : VerdictText::tr("Leg %1 would be %2 mm, below its minimum %3 mm (by %4 mm)");
    return text.arg(QString::number(verdict.leg), number(value, decimals),
                    QString::fromStdString(formatNumber(bound)), number(by, decimals));
}

} // namespace

QString verdictText(const Verdict& verdict) {
    switch (verdict.reason) {
    case Verdict::Reason::Ok:
        return VerdictText::tr("Reachable");
    case Verdict::Reason::NotFinite:
        return VerdictText::tr("A coordinate is not a number");
    case Verdict::Reason::LegAboveMax:
    case Verdict::Reason::LegBelowMin:
        return legText(verdict);
    case Verdict::Reason::NearSingular:
        return VerdictText::tr("Too close to a singular pose: margin %1, at least %2 is needed")
            .arg(number(verdict.value, 3), number(verdict.bound, 3));
    case Verdict::Reason::OtherBranch:
        return VerdictText::tr("The legs would lead to another pose than the target");
    case Verdict::Reason::PathNearSingular:
        return VerdictText::tr("The path comes too close to a singular pose at %1 % of the way")
            .arg(number(verdict.fraction * 100.0, 0));
    }
    return {};
}

QString verdictTextFromWords(const QString& words) {
    static const QRegularExpression leg(QStringLiteral("^leg (\\d) (above max_mm|below min_mm)$"));
    static const QRegularExpression path(QStringLiteral("^path near singular at (\\d+) %$"));
    if (const auto match = leg.match(words); match.hasMatch()) {
        const bool above = match.captured(2).startsWith(QLatin1String("above"));
        return (above ? VerdictText::tr("Leg %1 would be above its maximum")
                      : VerdictText::tr("Leg %1 would be below its minimum"))
            .arg(match.captured(1));
    }
    if (const auto match = path.match(words); match.hasMatch()) {
        return VerdictText::tr("The path comes too close to a singular pose at %1 % of the way")
            .arg(match.captured(1));
    }
    if (words == QLatin1String("near singular")) {
        return VerdictText::tr("Too close to a singular pose");
    }
    if (words == QLatin1String("other branch")) {
        return VerdictText::tr("The legs would lead to another pose than the target");
    }
    return words == QLatin1String("invalid-input") ? VerdictText::tr("A coordinate is not a number") : words;
}

} // namespace hexapose
