// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/pose_field.h"

#include "core/base/number_text.h"
#include "ui/common/theme.h"

#include <QLineEdit>
#include <QRegularExpression>
#include <QWheelEvent>

namespace hexapose {

namespace {
constexpr int kDecimals = 6;
constexpr int kLeastDecimals = 2;
constexpr double kLargest =
    1e6; // mm or degrees: far beyond any machine, so the limits judge and not the field
} // namespace

PoseField::PoseField(QWidget* parent) : QDoubleSpinBox(parent) {
    setLocale(QLocale::c());
    setGroupSeparatorShown(false);
    setDecimals(kDecimals);
    setRange(-kLargest, kLargest);
    setSingleStep(1.0);
    setButtonSymbols(QAbstractSpinBox::NoButtons);
    setAlignment(Qt::AlignRight);
    setKeyboardTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0000.000")) + 18);
    setProperty("wrong", false);
    connect(lineEdit(), &QLineEdit::textChanged, this, [this] {
        mark();
        emit edited();
    });
}

void PoseField::showValue(double value) {
    setValue(value); // tells nobody of its new text
    mark();
}

void PoseField::mark() {
    setStyleProperty(*this, "wrong", !isComplete());
}

bool PoseField::isComplete() const {
    return parseNumber(text().toStdString()).has_value();
}

QString PoseField::textFromValue(double value) const {
    std::string text = formatFixed(value, kDecimals);
    const std::size_t least = text.find('.') + 1 + kLeastDecimals;
    while (text.size() > least && text.back() == '0') {
        text.pop_back();
    }
    return QString::fromStdString(text);
}

double PoseField::valueFromText(const QString& text) const {
    return parseNumber(text.toStdString()).value_or(value());
}

QValidator::State PoseField::validate(QString& text, int& /*position*/) const {
    static const QRegularExpression beginning(QStringLiteral("^\\s*[+-]?\\d{0,7}(\\.\\d{0,6})?\\s*$"));
    if (!beginning.match(text).hasMatch()) {
        return QValidator::Invalid;
    }
    const std::optional<double> number = parseNumber(text.trimmed().toStdString());
    if (!number) {
        return QValidator::Intermediate;
    }
    return *number >= minimum() && *number <= maximum() ? QValidator::Acceptable : QValidator::Invalid;
}

void PoseField::wheelEvent(QWheelEvent* event) {
    // Scrolling the mouse over a field must not change a target by accident.
    if (hasFocus()) {
        QDoubleSpinBox::wheelEvent(event);
    } else {
        event->ignore();
    }
}

} // namespace hexapose
