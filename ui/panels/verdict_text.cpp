// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/verdict_text.h"

#include "core/geometry/number_text.h"
#include "core/geometry/units.h"
#include "ui/common/status_text.h"

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

QString axisText(int axis) {
    return axis >= 1 && axis <= 6 ? coordinateTexts()[static_cast<std::size_t>(axis - 1)].symbol : QString();
}

QString envelopeText(const Verdict& verdict) {
    const int coordinate = verdict.axis - 1;
    const QString unit = coordinate < 3 ? QStringLiteral(" mm") : QString::fromUtf8("\u00b0");
    return VerdictText::tr("%1 would be %2, outside its allowed \u00b1%3")
        .arg(axisText(verdict.axis), number(shownCoordinate(coordinate, verdict.value), 1) + unit,
             QString::fromStdString(formatNumber(shownCoordinate(coordinate, verdict.bound))) + unit);
}

QString legPaceText(const Verdict& verdict) {
    const QString text =
        verdict.reason == Verdict::Reason::LegTooFast
            ? VerdictText::tr("Leg %1 would move at %2 mm/s, faster than its %3 mm/s")
            : VerdictText::tr("Leg %1 would accelerate by %2 mm/s\u00b2, more than its %3 mm/s\u00b2");
    return text.arg(QString::number(verdict.leg), number(mmFromMetres(verdict.value), 1),
                    number(mmFromMetres(verdict.bound), 1));
}

QString withPlace(const QString& reason, const QString& percent) {
    return VerdictText::tr("%1, at %2 % of the way").arg(reason, percent);
}

QString reasonText(const Verdict& verdict) {
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
        return VerdictText::tr("The path comes too close to a singular pose");
    case Verdict::Reason::OutsideEnvelope:
        return envelopeText(verdict);
    case Verdict::Reason::OtherSide:
        return VerdictText::tr("Beyond the singular poses: q would be %1, at least %2 is needed")
            .arg(number(verdict.value, 3), number(verdict.bound, 3));
    case Verdict::Reason::LegTooFast:
    case Verdict::Reason::LegTooHard:
        return legPaceText(verdict);
    }
    return {};
}

/// The reason of a verdict's words, without the place.
QString reasonTextFromWords(const QString& words) {
    static const QRegularExpression leg(
        QStringLiteral("^leg (\\d) (above max_mm|below min_mm|too fast|accelerated too hard)$"));
    static const QRegularExpression axis(QStringLiteral("^(x|y|z|alpha|beta|gamma) outside the envelope$"));
    if (const auto match = leg.match(words); match.hasMatch()) {
        const QString what = match.captured(2);
        const QString text =
            what.startsWith(QLatin1String("above"))   ? VerdictText::tr("Leg %1 would be above its maximum")
            : what.startsWith(QLatin1String("below")) ? VerdictText::tr("Leg %1 would be below its minimum")
            : what.startsWith(QLatin1String("too"))   ? VerdictText::tr("Leg %1 would move too fast")
                                                      : VerdictText::tr("Leg %1 would accelerate too hard");
        return text.arg(match.captured(1));
    }
    if (const auto match = axis.match(words); match.hasMatch()) {
        for (int i = 1; i <= 6; ++i) {
            if (coordinateTexts()[static_cast<std::size_t>(i - 1)].word == match.captured(1)) {
                return VerdictText::tr("%1 would be outside its allowed range").arg(axisText(i));
            }
        }
    }
    if (words == QLatin1String("path near singular")) {
        return VerdictText::tr("The path comes too close to a singular pose");
    }
    if (words == QLatin1String("near singular")) {
        return VerdictText::tr("Too close to a singular pose");
    }
    if (words == QLatin1String("across the singular poses")) {
        return VerdictText::tr("Beyond the singular poses");
    }
    if (words == QLatin1String("other branch")) {
        return VerdictText::tr("The legs would lead to another pose than the target");
    }
    return words == QLatin1String("invalid-input") ? VerdictText::tr("A coordinate is not a number")
                                                   : QString();
}

/// "reason at 63 %": the reason and the number.
QRegularExpressionMatch placeIn(const QString& words) {
    static const QRegularExpression place(QStringLiteral("^(.*) at (\\d+) %$"));
    return place.match(words);
}

} // namespace

QString verdictText(const Verdict& verdict) {
    const bool onTheWay = !verdict.ok() && verdict.fraction < 1.0;
    return onTheWay ? withPlace(reasonText(verdict), number(verdict.fraction * 100.0, 0))
                    : reasonText(verdict);
}

QString verdictTextFromWords(const QString& words) {
    const auto place = placeIn(words);
    const QString reason = reasonTextFromWords(place.hasMatch() ? place.captured(1) : words);
    if (reason.isEmpty()) {
        return words;
    }
    return place.hasMatch() ? withPlace(reason, place.captured(2)) : reason;
}

bool liesOnTheWay(const QString& words) {
    return placeIn(words).hasMatch();
}

} // namespace hexapose
