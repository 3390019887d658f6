// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/chart_history.h"
#include "ui/charts/chart_range.h"
#include "ui/common/theme.h"

#include <QChartView>

#include <optional>

QT_BEGIN_NAMESPACE
class QValueAxis;
QT_END_NAMESPACE

namespace hexapose {

class CurveItem;

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
class TimeChart final : public QChartView {
    Q_OBJECT
public:
    explicit TimeChart(QWidget* parent = nullptr);
    ~TimeChart() override;
    void setSubject(const ChartSubject& subject);
    const ChartSubject& subject() const { return m_subject; }
    void setColors(const ThemeColors& colors);
    void setTimeTitle(const QString& title);
    void showWindow(const ChartHistory& history, double from, double to);
    void showCursor(const ChartHistory& history, std::optional<double> time);
    AxisRange verticalRange() const { return m_range; }

signals:
    void cursorMoved(double time);
    void cursorLeft();
    void zoomed(double factor); ///< of the window's length

protected:
    void wheelEvent(QWheelEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    ChartSubject m_subject;
    AxisRange m_range;
    QColor m_measuredColor;
    QColor m_targetColor;
    QValueAxis* m_time;
    QValueAxis* m_value;
    CurveItem* m_curves;
};

} // namespace hexapose
