// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/events/motion_check_text.h"

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "ui/common/status_text.h"

#include <QCoreApplication>

#include <cmath>

namespace hexapose {

namespace {

struct MotionCheckText {
    Q_DECLARE_TR_FUNCTIONS(hexapose::MotionCheckText)
};

QString number(double value, int decimals) {
    return QString::fromStdString(formatFixed(value, decimals));
}

/// Where only the reason is known, as from a log.
bool hasNumbers(const MotionCheck& check) {
    return std::isfinite(check.value) && std::isfinite(check.bound);
}

QString legText(const MotionCheck& check) {
    if (!hasNumbers(check)) {
        const QString text = check.reason == MotionCheck::Reason::LegAboveMax
                                 ? MotionCheckText::tr("Leg %1 would be above its maximum")
                                 : MotionCheckText::tr("Leg %1 would be below its minimum");
        return text.arg(check.leg);
    }
    const double value = mmFromMetres(check.value);
    const double bound = mmFromMetres(check.bound);
    const double by = std::abs(value - bound);
    // A tenth tells enough, unless it would read "by 0.0 mm".
    const int decimals = by < 0.1 ? 4 : 1;
    const QString text =
        check.reason == MotionCheck::Reason::LegAboveMax
            ? MotionCheckText::tr("Leg %1 would be %2 mm, above its maximum %3 mm (by %4 mm)")
            : MotionCheckText::tr("Leg %1 would be %2 mm, below its minimum %3 mm (by %4 mm)");
    return text.arg(QString::number(check.leg), number(value, decimals),
                    QString::fromStdString(formatNumber(bound)), number(by, decimals));
}

QString axisText(int axis) {
    return axis >= 1 && axis <= 6 ? coordinateTexts()[static_cast<std::size_t>(axis - 1)].symbol : QString();
}

QString envelopeText(const MotionCheck& check) {
    if (!hasNumbers(check)) {
        return MotionCheckText::tr("%1 would be outside its allowed range").arg(axisText(check.axis));
    }
    const int coordinate = check.axis - 1;
    const QString unit = coordinate < 3 ? QStringLiteral(" mm") : QString::fromUtf8("\u00b0");
    return MotionCheckText::tr("%1 would be %2, outside its allowed \u00b1%3")
        .arg(axisText(check.axis), number(toDisplay(coordinate, check.value), 1) + unit,
             QString::fromStdString(formatNumber(toDisplay(coordinate, check.bound))) + unit);
}

QString legRateText(const MotionCheck& check) {
    if (!hasNumbers(check)) {
        const QString text = check.reason == MotionCheck::Reason::LegSpeed
                                 ? MotionCheckText::tr("Leg %1 would exceed its speed limit")
                                 : MotionCheckText::tr("Leg %1 would exceed its acceleration limit");
        return text.arg(check.leg);
    }
    const QString text =
        check.reason == MotionCheck::Reason::LegSpeed
            ? MotionCheckText::tr("Leg %1 would move at %2 mm/s, above its limit of %3 mm/s")
            : MotionCheckText::tr(
                  "Leg %1 would accelerate by %2 mm/s\u00b2, above its limit of %3 mm/s\u00b2");
    return text.arg(QString::number(check.leg), number(mmFromMetres(check.value), 1),
                    number(mmFromMetres(check.bound), 1));
}

QString withPlace(const QString& reason, const QString& percent) {
    return MotionCheckText::tr("%1, at %2 % of the path").arg(reason, percent);
}

QString reasonText(const MotionCheck& check) {
    switch (check.reason) {
    case MotionCheck::Reason::Ok:
        return MotionCheckText::tr("Reachable");
    case MotionCheck::Reason::NotFinite:
        return MotionCheckText::tr("A coordinate is not a number");
    case MotionCheck::Reason::LegAboveMax:
    case MotionCheck::Reason::LegBelowMin:
        return legText(check);
    case MotionCheck::Reason::NearSingular:
        if (!hasNumbers(check)) {
            return MotionCheckText::tr("Too close to a singular pose");
        }
        return MotionCheckText::tr("Too close to a singular pose: margin %1, at least %2 is needed")
            .arg(number(check.value, 3), number(check.bound, 3));
    case MotionCheck::Reason::OtherAssemblyMode:
        return MotionCheckText::tr("The legs would reach another pose than the target");
    case MotionCheck::Reason::PathNearSingular:
        return MotionCheckText::tr("The path comes too close to a singular pose");
    case MotionCheck::Reason::OutsideEnvelope:
        return envelopeText(check);
    case MotionCheck::Reason::WrongSideOfSingularity:
        if (!hasNumbers(check)) {
            return MotionCheckText::tr("Beyond the singular poses");
        }
        return MotionCheckText::tr("Beyond the singular poses: q would be %1, at least %2 is needed")
            .arg(number(check.value, 3), number(check.bound, 3));
    case MotionCheck::Reason::LegSpeed:
    case MotionCheck::Reason::LegAcceleration:
        return legRateText(check);
    case MotionCheck::Reason::PlanTooLong:
        return MotionCheckText::tr(
            "The path runs along a singular pose, or is too long to be checked in time");
    case MotionCheck::Reason::StartMoved:
        return MotionCheckText::tr("The platform has moved since the motion was planned");
    case MotionCheck::Reason::LimitsChanged:
        return MotionCheckText::tr("The limits have changed since the motion was planned");
    }
    return {};
}

} // namespace

QString motionCheckText(const MotionCheck& check) {
    const bool alongPath = !check.ok() && check.fraction < 1.0;
    return alongPath ? withPlace(reasonText(check), number(check.fraction * 100.0, 0)) : reasonText(check);
}

} // namespace hexapose
