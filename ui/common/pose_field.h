// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace hexapose {

/// A coordinate to be typed, in mm or degrees. '.' is the decimal sign in every language; nothing is clamped
/// and nothing is rounded silently: what cannot be a number is shown as wrong and isComplete() says no.
class PoseField final : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit PoseField(QWidget* parent = nullptr);
    /// Unlike setValue() also when that is the value already, and another text is typed over it.
    void showValue(double value);
    /// The text is a number as it stands.
    bool isComplete() const;
    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;

signals:
    /// Each keystroke, complete or not.
    void edited();

protected:
    void wheelEvent(QWheelEvent* event) override;

private:
    void mark();
};

} // namespace hexapose
