// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/common/theme.h"

#include <QObject>

class QAction;
class QMenu;

namespace hexapose {

/// Language and look in a menu, changed while the program runs.
class LookMenu final : public QObject {
    Q_OBJECT
public:
    LookMenu(const QString& language, ThemeKind theme, QObject* parent);
    ~LookMenu() override;
    void addTo(QMenu& menu);

signals:
    void languageChosen(const QString& code);
    void themeChosen(hexapose::ThemeKind kind);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void retranslate();

    QMenu* m_languages;
    QMenu* m_themes;
    QAction* m_light;
    QAction* m_dark;
};

} // namespace hexapose
