// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/chart_history.h"
#include "ui/common/theme.h"
#include "ui/plot/plot_layout.h"

#include <QWidget>

#include <optional>

namespace hexapose {

/// What one chart shows: which channels of the history, under which words, and its least range.
struct ChartSubject {
    QString title;
    QString unit;
    std::size_t measured = 0;          ///< channel
    std::optional<std::size_t> target; ///< channel, dashed under the measured one
    double low = -1.0;
    double high = 1.0;
    int decimals = 3; ///< of the cursor's read-out
};

/// One quantity over time: measured solid over target dashed.
class TimeChart final : public QWidget {
    Q_OBJECT
public:
    explicit TimeChart(QWidget* parent = nullptr);
    void setSubject(const ChartSubject& subject);
    const ChartSubject& subject() const { return m_subject; }
    void setColors(const ThemeColors& colors);
    void setTimeTitle(const QString& title);
    void showWindow(const ChartHistory& history, double from, double to);
    void showCursor(const ChartHistory& history, std::optional<double> time);
    AxisRange verticalRange() const { return m_plot.y; }
    const Plot& plot() const { return m_plot; }
    PlotLayout layOut() const; ///< where the ticks and the values are on this widget

signals:
    void cursorMoved(double time);
    void cursorLeft();
    void zoomed(double factor); ///< of the window's length

protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct Cursor {
        double at;
        QString time;
        QString values;
        bool operator==(const Cursor&) const = default;
    };

    QRectF plotArea() const;
    void paintCursor(QPainter& painter, const PlotStyle& style) const;

    ChartSubject m_subject;
    Plot m_plot;
    std::optional<Cursor> m_cursor;
    ThemeColors m_colors;
};

} // namespace hexapose
