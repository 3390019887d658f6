// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/language.h"
#include "ui/common/status_text.h"
#include "ui/common/theme.h"

#include <QFile>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hexapose {
namespace {

TEST(Language, IsUnderstoodInTheWaysItIsWritten) {
    for (const char* chinese : {"zh", "zh_CN", "zh-Hans-CN", "zh_CN.UTF-8", "ZH_cn", "zh_TW"}) {
        EXPECT_EQ(languageFromText(QString::fromLatin1(chinese)), "zh_CN") << chinese;
    }
    EXPECT_EQ(languageFromText(QStringLiteral("en_US.UTF-8")), "en");
    for (const char* unknown : {"", "xx", "klingon", "1"}) {
        EXPECT_EQ(languageFromText(QString::fromLatin1(unknown)), "") << unknown;
    }
    EXPECT_EQ(desktopLanguage(QLocale(QStringLiteral("zh_TW"))), "zh_CN");
    EXPECT_EQ(desktopLanguage(QLocale(QStringLiteral("de_DE"))), "en");
    EXPECT_EQ(desktopLanguage(QLocale::c()), "en");
}

TEST(Language, IsSwitchedBackAndForthFromWhatTheProgramCarries) {
    const QString english = stateText(RunState::Moving);
    {
        LanguageSwitch language;
        EXPECT_TRUE(language.choose(QStringLiteral("zh_CN")));
        EXPECT_NE(stateText(RunState::Moving), english);
        EXPECT_FALSE(language.choose(QStringLiteral("xx")));
        EXPECT_EQ(language.code(), "zh_CN");
        EXPECT_TRUE(language.choose(QStringLiteral("en")));
        EXPECT_EQ(stateText(RunState::Moving), english);
        EXPECT_TRUE(language.choose(QStringLiteral("zh_CN")));
    }
    EXPECT_EQ(stateText(RunState::Moving), english);
}

/// Relative luminance and contrast as the Web Content Accessibility Guidelines define them.
double luminance(const QColor& color) {
    const auto part = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * part(color.redF()) + 0.7152 * part(color.greenF()) + 0.0722 * part(color.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)}); // by value
    return (high + 0.05) / (low + 0.05);
}

TEST(Theme, TextAndStatusColoursCanBeRead) {
    constexpr double kText = 4.5;  // WCAG AA
    constexpr double kLarge = 3.0; // for large text and for what stands out by being grey
    for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark}) {
        const ThemeColors colors = themeColors(kind);
        for (const QColor& color :
             {colors.text, colors.muted, colors.good, colors.warn, colors.bad, colors.accent}) {
            EXPECT_GE(contrast(color, colors.surface), kText) << toWord(kind) << color.name().toStdString();
        }
        EXPECT_GE(contrast(colors.onAccent, colors.accent), kText) << toWord(kind);
        EXPECT_GE(contrast(colors.idle, colors.surface), kLarge) << toWord(kind);
        EXPECT_EQ(themeFromWord(toWord(kind)), kind);
    }
    EXPECT_FALSE(themeFromWord("pink"));
}

TEST(Theme, StyleSheetHasNoColourLeftOpen) {
    ASSERT_TRUE(QFile::exists(QStringLiteral(":/icons/hexapose.svg")));
    applyTheme(*qApp, ThemeKind::Dark);
    EXPECT_FALSE(qApp->styleSheet().isEmpty());
    EXPECT_FALSE(qApp->styleSheet().section(QStringLiteral("*/"), 1).contains(QLatin1Char('@')));
}

} // namespace
} // namespace hexapose
