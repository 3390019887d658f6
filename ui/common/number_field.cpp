// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/number_field.h"

#include "core/base/number_text.h"
#include "core/base/typed_number.h"
#include "ui/common/theme.h"

#include <QComboBox>
#include <QEvent>
#include <QKeyEvent>
#include <QSignalBlocker>

#include <cmath>

namespace hexapose {

namespace {

constexpr int kDecimals = 6;
constexpr int kLeastDecimals = 2;
constexpr double kLargestAngle = 360.0; // degrees
constexpr double kPageSteps = 10.0;

QString faultText(TypedNumberFault fault) {
    switch (fault) {
    case TypedNumberFault::Empty:
        return NumberField::tr("nothing typed");
    case TypedNumberFault::Unfinished:
        return NumberField::tr("unfinished");
    case TypedNumberFault::BlankInside:
        return NumberField::tr("contains a space");
    case TypedNumberFault::TwoDecimalMarks:
        return NumberField::tr("two decimal marks");
    case TypedNumberFault::NotANumber:
        return NumberField::tr("not a number");
    case TypedNumberFault::NoSuchSize:
        return NumberField::tr("too large or too small");
    case TypedNumberFault::None:
        break;
    }
    return {};
}

QString rangeText(const NumberBounds& bounds) {
    const QString largest = QString::fromStdString(formatFixed(bounds.largest, 0));
    return bounds.least == -bounds.largest
               ? NumberField::tr("beyond \u00b1%1").arg(largest)
               : NumberField::tr("not in %1 .. %2")
                     .arg(QString::fromStdString(formatFixed(bounds.least, 0)), largest);
}

QString textOf(double value, bool whole) {
    std::string text = formatFixed(value, whole ? 0 : kDecimals);
    if (!whole) {
        const std::size_t least = text.find('.') + 1 + kLeastDecimals;
        while (text.size() > least && text.back() == '0') {
            text.pop_back();
        }
    }
    return QString::fromStdString(text);
}

} // namespace

NumberBounds coordinateBounds(int coordinate) {
    return coordinate < 3 ? NumberBounds{} : NumberBounds{-kLargestAngle, kLargestAngle};
}

NumberReading readNumber(const QString& text, const NumberBounds& bounds) {
    const TypedNumber typed = readTypedNumber(text.toStdString());
    if (!typed.ok()) {
        return {std::nullopt, faultText(typed.fault)};
    }
    if (bounds.whole && typed.value != std::floor(typed.value)) {
        return {std::nullopt, NumberField::tr("not a whole number")};
    }
    if (typed.value < bounds.least || typed.value > bounds.largest) {
        return {std::nullopt, rangeText(bounds)};
    }
    return {typed.value, {}};
}

NumberField::NumberField(const NumberBounds& bounds, QWidget* parent) : QLineEdit(parent), m_bounds(bounds) {
    setProperty("number", true);
    setProperty("wrong", false);
    connect(this, &QLineEdit::textChanged, this, [this] {
        read();
        emit edited();
    });
    showValue(bounds.least > 0.0 ? bounds.least : 0.0);
}

void NumberField::showValue(double value) {
    {
        const QSignalBlocker quiet(this);
        setText(textOf(value, m_bounds.whole));
    }
    read();
}

void NumberField::read() {
    m_reading = readNumber(text(), m_bounds);
    setAccessibleDescription(m_reading.refusal);
    // The editor of a box has no frame of its own to colour.
    auto* box = qobject_cast<QComboBox*>(parentWidget());
    setStyleProperty(box != nullptr ? static_cast<QWidget&>(*box) : *this, "wrong", isRefused());
}

void NumberField::stepBy(double steps) {
    if (isReadOnly() || !m_reading.value) {
        return;
    }
    // A step that would leave the range is none: the field never changes what it was asked for.
    const double next = *m_reading.value + steps;
    if (next >= m_bounds.least && next <= m_bounds.largest) {
        setText(textOf(next, m_bounds.whole));
        selectAll();
    }
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    const bool steps = event->key() == Qt::Key_Up || event->key() == Qt::Key_Down ||
                       event->key() == Qt::Key_PageUp || event->key() == Qt::Key_PageDown;
    if (steps && qobject_cast<QComboBox*>(parentWidget()) != nullptr) {
        event->ignore(); // the box has steps of its own
        return;
    }
    switch (event->key()) {
    case Qt::Key_Up:
        return stepBy(1.0);
    case Qt::Key_Down:
        return stepBy(-1.0);
    case Qt::Key_PageUp:
        return stepBy(kPageSteps);
    case Qt::Key_PageDown:
        return stepBy(-kPageSteps);
    default:
        QLineEdit::keyPressEvent(event);
    }
}

void NumberField::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        read();
    }
    QLineEdit::changeEvent(event);
}

} // namespace hexapose

#include "moc_number_field.cpp"
