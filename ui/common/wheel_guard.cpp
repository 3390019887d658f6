// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/wheel_guard.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>
#include <QTabBar>

namespace hexapose {

namespace {

bool changesByTheWheel(const QWidget& widget) {
    return qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QTabBar*>(&widget) != nullptr ||
           (qobject_cast<const QAbstractSlider*>(&widget) != nullptr &&
            qobject_cast<const QScrollBar*>(&widget) == nullptr);
}

/// Qt gives the focus to what the wheel is turned over before the wheel itself is delivered.
void refuseFocusByTheWheel(QWidget& widget) {
    if (widget.focusPolicy() == Qt::WheelFocus) {
        widget.setFocusPolicy(Qt::StrongFocus);
    }
}

} // namespace

WheelGuard::WheelGuard(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
    for (QWidget* widget : QApplication::allWidgets()) {
        refuseFocusByTheWheel(*widget);
    }
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
    if (!watched->isWidgetType()) {
        return QObject::eventFilter(watched, event);
    }
    auto& widget = static_cast<QWidget&>(*watched);
    if (event->type() == QEvent::Polish) { // before it is seen first
        refuseFocusByTheWheel(widget);
    } else if (event->type() == QEvent::Wheel && changesByTheWheel(widget) && !widget.hasFocus()) {
        event->ignore(); // so that Qt offers it to what is around
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace hexapose

#include "moc_wheel_guard.cpp"
