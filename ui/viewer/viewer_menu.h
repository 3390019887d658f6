// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

class QAction;
class QMenu;

namespace hexapose {

class LookMenu;
class ViewerWindow;

/// The menu of the viewer's window.
class ViewerMenu final : public QObject {
    Q_OBJECT
public:
    ViewerMenu(ViewerWindow& window, LookMenu& look);
    /// Those opened last, the newest first.
    void showRecent(const QStringList& files);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void enable();
    void retranslate();
    void showKeys();

    ViewerWindow& m_window;
    LookMenu& m_look;
    QMenu* m_file;
    QAction* m_open;
    QAction* m_openInLayout;
    QMenu* m_recent;
    QAction* m_export;
    QAction* m_close;
    QAction* m_quit;
    QMenu* m_charts;
    QAction* m_addChart;
    QAction* m_saveLayout;
    QAction* m_loadLayout;
    QAction* m_usualLayout;
    QMenu* m_view;
    QMenu* m_help;
    QAction* m_keys;
};

} // namespace hexapose
