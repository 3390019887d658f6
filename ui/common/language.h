// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QObject>
#include <QString>
#include <QTranslator>

#include <vector>

namespace hexapose {

/// A language of the screen: its code on the command line and its name in itself.
struct Language {
    QString code; ///< "en", "zh_CN"
    QString name;
};
const std::vector<Language>& languages();

/// The code of a shipped language that a text means ("zh", "zh-CN", "zh_CN.UTF-8", "EN" ...); empty for none.
QString languageFromText(const QString& text);
/// What the desktop asks for: Simplified Chinese for any Chinese, else English.
QString desktopLanguage(const QLocale& desktop = QLocale::system());

/// Installs the translators of one language at a time. Widgets hear of a change by QEvent::LanguageChange.
/// Numbers are not touched: they are written with '.' in every language.
class LanguageSwitch final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    ~LanguageSwitch() override;
    /// False for a language that is not shipped; the present one stays.
    bool choose(const QString& code);
    const QString& code() const { return m_code; }

private:
    QTranslator m_own;
    QTranslator m_toolkit; ///< Qt's own dialogs
    QString m_code = QStringLiteral("en");
};

} // namespace hexapose
