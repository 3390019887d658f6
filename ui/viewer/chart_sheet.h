// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewer/log_chart.h"
#include "ui/viewer/view_history.h"

#include <QWidget>

#include <memory>
#include <vector>

class QVBoxLayout;

namespace hexapose {

/// The charts of one log, one below the other: they share their time and their left margin.
class ChartSheet final : public QWidget {
    Q_OBJECT
public:
    explicit ChartSheet(QWidget* parent = nullptr);

    void setTable(const std::shared_ptr<const Table>& table);
    const std::shared_ptr<const Table>& table() const { return m_curves.table(); }
    /// Nothing where the log lacks it.
    std::optional<Curve> curve(const CurveSpec& spec) { return m_curves.find(spec); }
    void setColors(const ThemeColors& colors, ThemeKind theme);

    void setChartLayout(const ChartLayout& layout);
    ChartLayout chartLayout() const;
    std::size_t chartCount() const { return m_charts.size(); }
    LogChart& chart(std::size_t index) { return *m_charts[index].widget; }
    std::size_t currentChart() const { return m_current; }
    void addChart(const ChartSpec& chart);
    void removeChart(std::size_t index);
    void addCurve(std::size_t index, const CurveSpec& curve);
    void removeCurve(std::size_t index, const CurveSpec& curve);

    const TimeSpan& time() const { return m_history.view().time; }
    const PageView& view() const { return m_history.view(); }
    void showTime(const TimeSpan& time, ViewHistory::Step step = ViewHistory::Step::Single);
    void zoom(double factor, std::optional<double> about = std::nullopt);
    void pan(double part); ///< of the view
    void fit();
    void goBack();
    void goForward();
    bool canGoBack() const { return m_history.canGoBack(); }
    bool canGoForward() const { return m_history.canGoForward(); }

    const Cursors& cursors() const { return m_cursors; }
    void setCursors(const Cursors& cursors);
    /// One row on or back, of the cursor that was set last.
    void stepCursor(int rows);

    QSize minimumSizeHint() const override;

signals:
    void viewChanged();
    void cursorsChanged();
    void layoutChanged();
    void exportRequested(const hexapose::ChartSpec& chart);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Entry {
        int id;
        ChartSpec spec;
        LogChart* widget;
    };

    void makeWidget(Entry& entry);
    Entry* find(const LogChart* widget);
    void showAll();
    void alignLeft();
    void showView(PageView view, ViewHistory::Step step);
    TimeSpan whole() const;
    void setCursor(char which, std::optional<double> time);
    double cursorPlace() const;
    void zoomValues(Entry& entry, double factor, double about);
    void showMenu(LogChart& chart, QPoint position);
    void layoutEdited();

    CurveFinder m_curves;
    TableMarks m_marks;
    std::vector<Entry> m_charts;
    std::size_t m_current = 0;
    int m_nextId = 0;
    ViewHistory m_history;
    Cursors m_cursors;
    char m_lastCursor = 'a';
    ThemeColors m_colors;
    ThemeKind m_theme = ThemeKind::Light;
    QVBoxLayout* m_column;
};

} // namespace hexapose
