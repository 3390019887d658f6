// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/common/theme.h"

#include <QObject>

class QAction;
class QMainWindow;
class QMenu;

namespace hexapose {

/// The menu of a window: language and look, changed while it runs, and the keys explained.
class WindowMenu final : public QObject {
    Q_OBJECT
public:
    WindowMenu(QMainWindow& window, const QString& language, ThemeKind theme);

signals:
    void languageChosen(const QString& code);
    void themeChosen(hexapose::ThemeKind kind);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void retranslate();
    void showKeys();

    QMainWindow& m_window;

    QMenu* m_file;
    QMenu* m_view;
    QAction* m_quit;
    QMenu* m_help;
    QAction* m_keys;
};

} // namespace hexapose
