// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QTextEdit>

#include <optional>

namespace hexapose {

/// A value to be read, not written. Its accessible name says what it is; the text that a screen reader gets
/// is the value itself. (A label would give its name alone, hence the line edit.)
class ReadOut final : public QLineEdit {
    Q_OBJECT
public:
    explicit ReadOut(QWidget* parent = nullptr);
    /// Room for so many characters.
    void setDigits(int digits);
    /// Fixed decimals with '.'; a dash when there is nothing to show.
    void showNumber(std::optional<double> value, int decimals);
    void showText(const QString& text);
    /// Grey, and said to be old.
    void setStale(bool stale);
    bool isStale() const { return m_stale; }
    static QString dash();
    /// As wide as its digits: what is left over goes to those who can use it.
    QSize sizeHint() const override { return {minimumWidth(), QLineEdit::sizeHint().height()}; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void describe();
    bool m_stale = false;
};

/// The same for a sentence that may need several lines.
class TextReadOut final : public QTextEdit {
    Q_OBJECT
public:
    explicit TextReadOut(int lines, QWidget* parent = nullptr);
    void showText(const QString& text);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fitHeight();
    int m_lines;
};

} // namespace hexapose
