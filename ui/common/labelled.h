// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

namespace hexapose {

/// What a button says to the eye, to a screen reader and to a pointer that rests on it.
inline void label(QAbstractButton& button, const QString& text, const QString& spoken, const QString& tip) {
    button.setText(text);
    button.setAccessibleName(spoken);
    button.setToolTip(tip);
}

/// The same words for the eye and the screen reader.
inline void label(QAbstractButton& button, const QString& text, const QString& tip = {}) {
    label(button, text, text, tip);
}

} // namespace hexapose
