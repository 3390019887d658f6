// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/theme.h"

#include <QFile>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>
#include <QVariant>
#include <QWidget>

#include <utility>

namespace hexapose {

namespace {

QString styleSheet(const ThemeColors& colors) {
    QFile file(QStringLiteral(":/theme/hexapose.qss"));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QString sheet = QString::fromUtf8(file.readAll());
    const std::pair<const char*, QColor> names[] = {
        {"@window", colors.window}, {"@surface", colors.surface},   {"@field", colors.field},
        {"@border", colors.border}, {"@text", colors.text},         {"@muted", colors.muted},
        {"@accent", colors.accent}, {"@onAccent", colors.onAccent}, {"@good", colors.good},
        {"@warn", colors.warn},     {"@bad", colors.bad},           {"@idle", colors.idle},
    };
    for (const auto& [name, color] : names) {
        sheet.replace(QLatin1String(name) + QLatin1Char(';'), color.name() + QLatin1Char(';'));
    }
    return sheet;
}

QPalette paletteOf(const ThemeColors& colors) {
    QPalette palette(colors.surface, colors.window);
    palette.setColor(QPalette::WindowText, colors.text);
    palette.setColor(QPalette::Base, colors.surface);
    palette.setColor(QPalette::AlternateBase, colors.window);
    palette.setColor(QPalette::Text, colors.text);
    palette.setColor(QPalette::PlaceholderText, colors.muted);
    palette.setColor(QPalette::Button, colors.surface);
    palette.setColor(QPalette::ButtonText, colors.text);
    palette.setColor(QPalette::ToolTipBase, colors.surface);
    palette.setColor(QPalette::ToolTipText, colors.text);
    palette.setColor(QPalette::Highlight, colors.accent);
    palette.setColor(QPalette::HighlightedText, colors.onAccent);
    palette.setColor(QPalette::Link, colors.accent);
    palette.setColor(QPalette::Mid, colors.border);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, colors.idle);
    }
    return palette;
}

} // namespace

std::optional<ThemeKind> themeFromWord(std::string_view word) {
    if (word == "light") {
        return ThemeKind::Light;
    }
    return word == "dark" ? std::optional(ThemeKind::Dark) : std::nullopt;
}

std::string_view toWord(ThemeKind kind) {
    return kind == ThemeKind::Dark ? "dark" : "light";
}

ThemeColors themeColors(ThemeKind kind) {
    if (kind == ThemeKind::Dark) {
        return {"#12161b", "#1b2128", "#12161b", "#323c47", "#e6edf3", "#9aa7b4",
                "#4c9ffe", "#0b1a2b", "#3fb950", "#e3a72f", "#ff6b62", "#6b7785"};
    }
    return {"#f1f4f7", "#ffffff", "#f8fafb", "#d3dae2", "#18212b", "#566373",
            "#0a64c2", "#ffffff", "#1a7f37", "#8f5f00", "#c4202b", "#8794a3"};
}

ThemeKind desktopTheme() {
    const QPalette palette = QApplication::palette();
    return palette.color(QPalette::WindowText).lightness() > palette.color(QPalette::Window).lightness()
               ? ThemeKind::Dark
               : ThemeKind::Light;
}

void applyTheme(QApplication& application, ThemeKind kind) {
    const ThemeColors colors = themeColors(kind);
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    application.setPalette(paletteOf(colors));
    application.setStyleSheet(styleSheet(colors));
}

QFont fontWithFallbacks(const QFont& base) {
    QFont font = base;
    font.setFamilies({base.family(), QStringLiteral("Noto Sans CJK SC"), QStringLiteral("Source Han Sans SC"),
                      QStringLiteral("Microsoft YaHei"), QStringLiteral("WenQuanYi Micro Hei"),
                      QStringLiteral("Droid Sans Fallback")});
    return font;
}

void setStyleProperty(QWidget& widget, const char* name, const QVariant& value) {
    if (widget.property(name) == value) {
        return;
    }
    widget.setProperty(name, value);
    widget.style()->unpolish(&widget);
    widget.style()->polish(&widget);
    widget.update();
}

void setTone(QWidget& widget, Tone tone) {
    static constexpr const char* kNames[] = {"idle", "good", "warn", "bad"};
    setStyleProperty(widget, "tone", QString::fromLatin1(kNames[static_cast<int>(tone)]));
}

Tone toneOf(const QWidget& widget) {
    const QString name = widget.property("tone").toString();
    return name == QLatin1String("good")   ? Tone::Good
           : name == QLatin1String("warn") ? Tone::Warn
           : name == QLatin1String("bad")  ? Tone::Bad
                                           : Tone::Idle;
}

} // namespace hexapose
