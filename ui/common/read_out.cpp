// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/read_out.h"

#include "core/base/number_text.h"
#include "ui/common/theme.h"

#include <QEvent>
#include <QTextDocument>

#include <cmath>

namespace hexapose {

ReadOut::ReadOut(QWidget* parent) : QLineEdit(parent) {
    setReadOnly(true);
    setFrame(false);
    setFocusPolicy(Qt::ClickFocus);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setContextMenuPolicy(Qt::NoContextMenu);
    setProperty("readOut", true);
    setProperty("stale", false);
    setDigits(8);
    setText(dash());
}

void ReadOut::setDigits(int digits) {
    setMinimumWidth(fontMetrics().horizontalAdvance(QLatin1Char('0')) * digits + 6);
}

void ReadOut::showNumber(std::optional<double> value, int decimals) {
    showText(value && std::isfinite(*value) ? QString::fromStdString(formatFixed(*value, decimals)) : dash());
}

void ReadOut::showText(const QString& newText) {
    if (text() == newText) {
        return;
    }
    setText(newText);
    if (!(alignment() & Qt::AlignRight)) {
        setCursorPosition(0); // the beginning of a long text matters, not its end
    }
}

void ReadOut::setStale(bool stale) {
    if (stale == m_stale) {
        return;
    }
    m_stale = stale;
    setStyleProperty(*this, "stale", stale);
    describe();
}

void ReadOut::describe() {
    setAccessibleDescription(m_stale ? tr("Old value") : QString());
}

void ReadOut::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        describe();
    }
    QLineEdit::changeEvent(event);
}

QString ReadOut::dash() {
    return QStringLiteral("--");
}

TextReadOut::TextReadOut(int lines, QWidget* parent) : QTextEdit(parent), m_lines(lines) {
    setReadOnly(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::ClickFocus);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setContextMenuPolicy(Qt::NoContextMenu);
    document()->setDocumentMargin(0);
    setProperty("readOut", true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    fitHeight();
}

void TextReadOut::showText(const QString& text) {
    if (toPlainText() != text) {
        setPlainText(text);
    }
}

// Measured as a text: letters of a font that stands in for another may be taller than this font's own.
void TextReadOut::fitHeight() {
    QTextDocument sample;
    sample.setDocumentMargin(0);
    sample.setDefaultFont(font());
    sample.setPlainText(QString(m_lines - 1, QLatin1Char('\n')) + QString::fromUtf8("A\u6bb5"));
    setFixedHeight(static_cast<int>(std::ceil(sample.size().height())) + 2);
}

void TextReadOut::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        fitHeight();
    }
    QTextEdit::changeEvent(event);
}

} // namespace hexapose

#include "moc_read_out.cpp"
