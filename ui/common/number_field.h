// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

#include <optional>

namespace hexapose {

/// What a field takes.
struct NumberBounds {
    double least = -1e6;
    double largest = 1e6;
    bool whole = false;
};

/// Of a pose coordinate (0..5) as shown, mm or degrees: far beyond any machine, so that its limits judge.
NumberBounds coordinateBounds(int coordinate);

/// A text as a number, or a few words on why it is none that the field takes: the one or the other.
struct NumberReading {
    std::optional<double> value;
    QString refusal;
};
NumberReading readNumber(const QString& text, const NumberBounds& bounds);

/// The one field for numbers. It keeps what is typed: nothing is filtered, clamped or rounded, and the text
/// is understood whole or refused whole, with a reason that the panel shows beside it. Whatever uses the
/// number stays disabled meanwhile.
class NumberField final : public QLineEdit {
    Q_OBJECT
public:
    explicit NumberField(const NumberBounds& bounds = {}, QWidget* parent = nullptr);
    const NumberBounds& bounds() const { return m_bounds; }
    /// Nothing while the text is refused.
    std::optional<double> value() const { return m_reading.value; }
    /// Empty while it is understood.
    const QString& refusal() const { return m_reading.refusal; }
    bool isRefused() const { return !m_reading.value; }
    /// Writes a number into the field; edited() is not emitted.
    void showValue(double value);

signals:
    /// Each change of the text that is not by showValue(), understood or refused.
    void edited();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void read();
    void stepBy(double steps);

    NumberBounds m_bounds;
    NumberReading m_reading;
};

} // namespace hexapose
