// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QKeyEvent>
#include <QWheelEvent>
#include <QWidget>
#include <QtTest/qtestspontaneevent.h>

namespace hexapose::testing {

/// Key by key, characters that no plain keyboard has among them (QTest knows ASCII alone).
inline void typeText(QWidget& widget, const QString& text) {
    for (const QChar letter : text) {
        for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
            QKeyEvent key(type, letter.unicode() < 0x80 ? letter.toUpper().unicode() : 0, Qt::NoModifier,
                          QString(letter));
            QApplication::sendEvent(&widget, &key);
        }
    }
}

/// One notch of the wheel over the middle of a widget, as from the window system: Qt offers it to the parents
/// of whatever is there, one after the other.
inline void turnWheelOver(QWidget& widget, int notches = -1) {
    QWidget* child = widget.childAt(widget.rect().center());
    QWidget& under = child != nullptr ? *child : widget;
    const QPointF at = under.rect().center();
    QWheelEvent wheel(at, under.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&wheel);
    qApp->notify(&under, &wheel);
}

} // namespace hexapose::testing
