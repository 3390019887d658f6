// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAccessible>
#include <QWidget>

namespace hexapose::testing {

/// The widget that a screen reader finds under a name; null for none.
inline QWidget* findByName(QWidget& root, const QString& name) {
    if (root.accessibleName() == name) {
        return &root;
    }
    for (QWidget* child : root.findChildren<QWidget*>()) {
        if (child->accessibleName() == name) {
            return child;
        }
    }
    return nullptr;
}

/// The text that a screen reader gets there; a mark that no value has when there is none to get.
inline QString spokenText(QWidget* widget) {
    QAccessibleInterface* accessible =
        widget != nullptr ? QAccessible::queryAccessibleInterface(widget) : nullptr;
    QAccessibleTextInterface* text = accessible != nullptr ? accessible->textInterface() : nullptr;
    return text != nullptr ? text->text(0, text->characterCount()) : QStringLiteral("(no text)");
}

inline QString spokenText(QWidget& root, const QString& name) {
    return spokenText(findByName(root, name));
}

} // namespace hexapose::testing
