// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/common/job.h"
#include "ui/viewer/log_page.h"

#include <QMainWindow>

#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QStackedWidget;
class QTabBar;

namespace hexapose {

class ColumnList;
class CursorTable;
class LogSummary;
class ProblemPanel;
class ViewBar;

/// The viewer's window: logs behind tabs, the charts of one of them, what is in it and what its cursors tell.
class ViewerWindow final : public QMainWindow {
    Q_OBJECT
public:
    explicit ViewerWindow(QWidget* parent = nullptr);

    void setColors(ThemeKind theme);
    /// Each in a tab of its own; the last one is shown.
    void openLogs(const QStringList& files, const FirstView& first = {});
    LogPage* current() const;
    int logCount() const;
    void closeLog(int index);
    void closeCurrent();

    // What the menu asks for.
    void askForLogs(bool inThisLayout);
    /// The whole page, or one chart of it.
    void askForExport(const std::optional<ChartSpec>& chart = std::nullopt);
    void exportTo(const QString& file, const std::optional<ChartSpec>& chart = std::nullopt);
    void saveLayout();
    void loadLayoutFile();

signals:
    /// Something can be shown of this file; its whole path.
    void logOpened(const QString& file);
    void currentChanged();

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void build();
    void wire();
    QWidget* buildSide();
    void showCurrent();
    void refresh();
    void complain(const QString& what);
    void retranslate();

    ThemeKind m_theme = ThemeKind::Light;
    ViewBar* m_bar;
    QTabBar* m_tabs;
    QStackedWidget* m_pages;
    QLabel* m_hint;
    LogSummary* m_summary;
    ColumnList* m_columns;
    ProblemPanel* m_problems;
    CursorTable* m_cursorTable;
    Job m_export;
    QString m_folder; ///< of the log opened last
};

} // namespace hexapose
