// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/look_menu.h"

#include "ui/common/language.h"

#include <QActionGroup>
#include <QEvent>
#include <QMenu>

namespace hexapose {

LookMenu::LookMenu(const QString& language, ThemeKind theme, QObject* parent)
    : QObject(parent), m_languages(new QMenu), m_themes(new QMenu) {
    auto* languageGroup = new QActionGroup(this);
    for (const Language& one : languages()) {
        QAction* action = m_languages->addAction(one.name); // each language is named in itself
        action->setCheckable(true);
        action->setChecked(one.code == language);
        languageGroup->addAction(action);
        connect(action, &QAction::triggered, this, [this, code = one.code] { emit languageChosen(code); });
    }
    auto* themeGroup = new QActionGroup(this);
    m_light = m_themes->addAction(QString());
    m_dark = m_themes->addAction(QString());
    for (QAction* action : {m_light, m_dark}) {
        action->setCheckable(true);
        themeGroup->addAction(action);
    }
    (theme == ThemeKind::Dark ? m_dark : m_light)->setChecked(true);
    connect(m_light, &QAction::triggered, this, [this] { emit themeChosen(ThemeKind::Light); });
    connect(m_dark, &QAction::triggered, this, [this] { emit themeChosen(ThemeKind::Dark); });
    m_languages->installEventFilter(this); // it hears of a change of language
    retranslate();
}

LookMenu::~LookMenu() {
    delete m_languages;
    delete m_themes;
}

void LookMenu::addTo(QMenu& menu) {
    menu.addMenu(m_languages);
    menu.addMenu(m_themes);
}

bool LookMenu::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    return QObject::eventFilter(watched, event);
}

void LookMenu::retranslate() {
    m_languages->setTitle(tr("&Language"));
    m_themes->setTitle(tr("&Theme"));
    m_light->setText(tr("&Light"));
    m_dark->setText(tr("&Dark"));
}

} // namespace hexapose

#include "moc_look_menu.cpp"
