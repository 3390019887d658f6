// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QColor>
#include <QFont>
#include <QString>

#include <optional>
#include <string_view>

namespace hexapose {

enum class ThemeKind { Light, Dark };

/// "light", "dark".
std::optional<ThemeKind> themeFromWord(std::string_view word);
std::string_view toWord(ThemeKind kind);

/// One accent colour, and status colours that can be read on the surface of either theme.
struct ThemeColors {
    QColor window;
    QColor surface;
    QColor field;
    QColor border;
    QColor text;
    QColor muted;
    QColor accent;
    QColor onAccent;
    QColor good;
    QColor warn;
    QColor bad;
    QColor idle;
};
ThemeColors themeColors(ThemeKind kind);

/// Whether the desktop asked for light text on dark ground; ask before applyTheme() changes the palette.
ThemeKind desktopTheme();
void applyTheme(QApplication& application, ThemeKind kind);

/// The desktop's font, with Simplified Chinese fonts behind it.
QFont fontWithFallbacks(const QFont& base);

/// What a status says; widgets carry it as the property "tone", which the style sheet colours.
enum class Tone { Idle, Good, Warn, Bad };
void setTone(QWidget& widget, Tone tone);
Tone toneOf(const QWidget& widget);

/// Sets a property that the style sheet selects by; repolishes only when it changes.
void setStyleProperty(QWidget& widget, const char* name, const QVariant& value);

} // namespace hexapose
