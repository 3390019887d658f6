// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>

namespace hexapose {

const std::vector<Language>& languages() {
    static const std::vector<Language> list = {
        {QStringLiteral("en"), QStringLiteral("English")},
        {QStringLiteral("zh_CN"), QString::fromUtf8("\u7b80\u4f53\u4e2d\u6587")},
    };
    return list;
}

QString languageFromText(const QString& text) {
    // "zh-Hans", "zh_CN.UTF-8@x" and "zh" all mean the one Chinese that there is.
    QString head = text.toLower();
    for (const QChar end : {QLatin1Char('.'), QLatin1Char('@'), QLatin1Char('_'), QLatin1Char('-')}) {
        head = head.left(head.indexOf(end) < 0 ? head.size() : head.indexOf(end));
    }
    for (const Language& language : languages()) {
        if (head == language.code.left(2)) {
            return language.code;
        }
    }
    return {};
}

QString desktopLanguage(const QLocale& desktop) {
    const QStringList wanted = desktop.uiLanguages();
    const QString code = languageFromText(wanted.isEmpty() ? desktop.name() : wanted.first());
    return code.isEmpty() ? QStringLiteral("en") : code;
}

LanguageSwitch::~LanguageSwitch() {
    choose(QStringLiteral("en"));
}

bool LanguageSwitch::choose(const QString& code) {
    if (code == m_code) {
        return true;
    }
    if (code == QLatin1String("en")) { // the language of the source
        QCoreApplication::removeTranslator(&m_own);
        QCoreApplication::removeTranslator(&m_toolkit);
        m_code = code;
        return true;
    }
    if (!m_own.load(QStringLiteral(":/translations/hexapose_") + code)) {
        return false;
    }
    if (m_toolkit.load(QStringLiteral("qtbase_") + code,
                       QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QCoreApplication::installTranslator(&m_toolkit);
    }
    QCoreApplication::installTranslator(&m_own);
    m_code = code;
    return true;
}

} // namespace hexapose

#include "moc_language.cpp"
