// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_layout.h"
#include "ui/viewer/log_plot.h"

#include <QPixmap>
#include <QWidget>

#include <optional>

namespace hexapose {

/// The two cursors of a page: times, s.
struct Cursors {
    std::optional<double> a, b;
    bool operator==(const Cursors&) const = default;
};

/// One chart of a log. It draws, and says what mouse and wheel ask for; its page decides, as all charts share
/// their time.
class LogChart final : public QWidget {
    Q_OBJECT
public:
    explicit LogChart(QWidget* parent = nullptr);

    void showPlot(const LogPlotSource& source, const TimeSpan& view, const std::optional<AxisRange>& values);
    const LogPlotSource& source() const { return m_source; }
    /// Of the frame, from the left of the widget, for its own numbers alone; and what all charts agree on.
    double neededLeft() const;
    void setLeft(double left);
    void setCursors(const Cursors& cursors);
    /// Where the pointer is, in this chart or in another one of the page.
    void setPointer(std::optional<double> time);
    /// What is shown beside the pointer: the time, and the value before it of each curve.
    QStringList pointerText() const;
    void setTimeTitleShown(bool isShown);

    const Plot& plot() const { return m_plot; }
    PlotLayout layOut() const;
    std::optional<double> pointerTime() const { return m_pointer; }

signals:
    void zoomRequested(double factor, double about);      ///< of the time shown
    void valueZoomRequested(double factor, double about); ///< of the values of this chart
    void panRequested(double seconds);                    ///< the view moves so far
    void boxRequested(hexapose::TimeSpan time, std::optional<hexapose::AxisRange> values);
    void cursorRequested(char which, double time); ///< 'a' or 'b'
    void pointerMoved(std::optional<double> time);
    void columnsDropped(const QStringList& names);
    void menuRequested(QPoint globalPosition);
    void entered(); ///< it has got the focus
    void resized();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    enum class Drag { None, Box, Pan, CursorA, CursorB };

    QRectF plotArea() const;
    PlotLayout layOut(double leastLeft) const;
    void invalidate();
    void drawPicture();
    void paintCursor(QPainter& painter, const PlotScale& scale, double time, const QString& name) const;
    void paintPointer(QPainter& painter, const PlotScale& scale) const;
    void paintBox(QPainter& painter, const PlotScale& scale) const;
    void endBox();
    std::optional<Drag> cursorAt(QPointF position) const;
    bool isTallBox() const;

    LogPlotSource m_source;
    TimeSpan m_view;
    Plot m_plot;
    double m_left = 0.0;
    bool m_isTimeTitleShown = true;
    Cursors m_cursors;
    std::optional<double> m_pointer; ///< over this chart
    std::optional<double> m_shown;   ///< over any of the page
    QPixmap m_picture;               ///< without cursors; null: to be drawn
    Drag m_drag = Drag::None;
    QPointF m_from, m_to; ///< of the drag
};

/// What the column list drags.
inline constexpr const char* kColumnsMime = "application/x-hexapose-columns";

} // namespace hexapose
