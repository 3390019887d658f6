// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/log_chart.h"

#include "ui/charts/chart_style.h"

#include <QContextMenuEvent>
#include <QFontMetricsF>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kCardMargin = 4.0;
constexpr double kCardRounding = 8.0; ///< of the card's corners
constexpr double kNear = 6.0;         ///< pixels, from a cursor to the pointer that takes it
constexpr double kLeastBox = 5.0;     ///< a shorter drag is a click
constexpr double kTallBox = 28.0;     ///< a box as tall zooms the values too
constexpr double kWheelZoom = 0.8;
constexpr double kWheelPan = 0.1; ///< of the view
constexpr QSize kLeastSize(240, 150);

} // namespace

LogChart::LogChart(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setAcceptDrops(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(kLeastSize);
    m_source.table = std::make_shared<Table>();
    m_source.colors = themeColors(ThemeKind::Light);
}

void LogChart::showPlot(const LogPlotSource& source, const TimeSpan& view,
                        const std::optional<AxisRange>& values) {
    m_source = source;
    m_view = view;
    m_plot = emptyLogPlot(source, view, values);
    setAccessibleName(tr("Chart %1").arg(m_plot.title));
    QStringList curves;
    for (const Curve& curve : source.curves)
        curves.append(curve.spec.name());
    setAccessibleDescription(curves.join(QStringLiteral(", ")));
    invalidate();
}

void LogChart::setTimeTitleShown(bool isShown) {
    if (isShown != m_isTimeTitleShown)
        invalidate();
    m_isTimeTitleShown = isShown;
}

void LogChart::invalidate() {
    m_picture = QPixmap();
    update();
}

double LogChart::neededLeft() const {
    return layOut(0.0).scale.frame.left();
}

void LogChart::setLeft(double left) {
    if (left != m_left)
        invalidate();
    m_left = left;
}

void LogChart::setCursors(const Cursors& cursors) {
    if (cursors != m_cursors)
        update();
    m_cursors = cursors;
}

QRectF LogChart::plotArea() const {
    return QRectF(rect()).adjusted(kCardMargin, kCardMargin, -kCardMargin, -kCardMargin);
}

PlotLayout LogChart::layOut() const {
    return layOut(m_left - plotArea().left());
}

PlotLayout LogChart::layOut(double leastLeft) const {
    Plot plot;
    plot.x = m_plot.x; // curves take no room
    plot.y = m_plot.y;
    plot.leastLeft = leastLeft;
    if (m_isTimeTitleShown)
        plot.xLabel = m_plot.xLabel;
    return layOutPlot(plot, plotArea(), chartStyle(m_source.colors, *this), *this);
}

void LogChart::drawPicture() {
    const double ratio = devicePixelRatioF();
    m_picture = QPixmap((QSizeF(size()) * ratio).toSize());
    m_picture.setDevicePixelRatio(ratio);
    m_picture.fill(Qt::transparent);
    const QRectF frame = layOut().scale.frame;
    fillLogPlot(m_plot, m_source, m_view, std::max(1, static_cast<int>(std::lround(frame.width() * ratio))));
    m_plot.leastLeft = m_left - plotArea().left();
    const PlotStyle style = chartStyle(m_source.colors, *this);
    QPainter painter(&m_picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(hasFocus() ? m_source.colors.accent : m_source.colors.border, style.pixel));
    painter.setBrush(style.ground);
    const double half = style.pixel / 2.0;
    painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), kCardRounding, kCardRounding);
    Plot drawn = m_plot;
    if (!m_isTimeTitleShown)
        drawn.xLabel.clear();
    paintPlot(painter, plotArea(), drawn, style);
}

void LogChart::paintEvent(QPaintEvent* /*event*/) {
    if (m_picture.isNull())
        drawPicture();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_picture);
    const PlotScale scale = layOut().scale;
    if (m_cursors.a)
        paintCursor(painter, scale, *m_cursors.a, QStringLiteral("A"));
    if (m_cursors.b)
        paintCursor(painter, scale, *m_cursors.b, QStringLiteral("B"));
    if (m_drag == Drag::Box)
        paintBox(painter, scale);
}

void LogChart::paintCursor(QPainter& painter, const PlotScale& scale, double time,
                           const QString& name) const {
    const PlotStyle style = chartStyle(m_source.colors, *this);
    const double x = style.onPixel(scale.at(time, 0.0).x());
    if (x < scale.frame.left() - 1.0 || x > scale.frame.right() + 1.0)
        return;
    painter.setPen(QPen(m_source.colors.text, 1.0));
    painter.drawLine(QPointF(x, scale.frame.top()), QPointF(x, scale.frame.bottom()));
    const QFontMetricsF metrics(style.tickFont, this);
    QRectF box(0.0, 0.0, metrics.horizontalAdvance(name) + 8.0, metrics.height());
    box.moveCenter(QPointF(x, scale.frame.top() - box.height() / 2.0)); // beside the texts of events
    painter.setFont(style.tickFont);
    painter.fillRect(box, m_source.colors.text);
    painter.setPen(m_source.colors.surface);
    painter.drawText(box, Qt::AlignCenter, name);
}

bool LogChart::isTallBox() const {
    return std::abs(m_to.y() - m_from.y()) >= kTallBox;
}

void LogChart::paintBox(QPainter& painter, const PlotScale& scale) const {
    QRectF box = QRectF(m_from, m_to).normalized().adjusted(0.0, 0.0, 0.0, 1.0) & scale.frame;
    if (!isTallBox()) {
        box.setTop(scale.frame.top());
        box.setBottom(scale.frame.bottom());
    }
    QColor fill = m_source.colors.accent;
    fill.setAlpha(40);
    painter.setPen(m_source.colors.accent);
    painter.setBrush(fill);
    painter.drawRect(box);
}

void LogChart::endBox() {
    const PlotScale scale = layOut().scale;
    const QRectF box = QRectF(m_from, m_to).normalized().adjusted(0.0, 0.0, 0.0, 1.0) & scale.frame;
    if (box.width() < kLeastBox)
        return;
    std::optional<AxisRange> values;
    if (isTallBox())
        values = AxisRange{scale.yAt(box.bottom()), scale.yAt(box.top())};
    emit boxRequested({scale.xAt(box.left()), scale.xAt(box.right())}, values);
}

std::optional<LogChart::Drag> LogChart::cursorAt(QPointF position) const {
    const PlotScale scale = layOut().scale;
    const auto isNear = [&](const std::optional<double>& time) {
        return time && std::abs(scale.at(*time, 0.0).x() - position.x()) <= kNear;
    };
    if (isNear(m_cursors.b))
        return Drag::CursorB;
    return isNear(m_cursors.a) ? std::optional(Drag::CursorA) : std::nullopt;
}

void LogChart::resizeEvent(QResizeEvent* event) {
    invalidate();
    QWidget::resizeEvent(event);
    emit resized();
}

void LogChart::wheelEvent(QWheelEvent* event) {
    const PlotScale scale = layOut().scale;
    const QPoint delta = event->angleDelta();
    if (!scale.frame.contains(event->position()) || delta.isNull()) {
        event->ignore(); // beside the frame the page scrolls
        return;
    }
    const double steps = (delta.y() != 0 ? delta.y() : delta.x()) / 120.0;
    const bool sideways = (event->modifiers() & Qt::ShiftModifier) != 0 || delta.y() == 0;
    if (sideways)
        emit panRequested(-steps * kWheelPan * m_view.length());
    else if ((event->modifiers() & Qt::ControlModifier) != 0)
        emit valueZoomRequested(std::pow(kWheelZoom, steps), scale.yAt(event->position().y()));
    else
        emit zoomRequested(std::pow(kWheelZoom, steps), scale.xAt(event->position().x()));
    event->accept();
}

void LogChart::mousePressEvent(QMouseEvent* event) {
    const PlotScale scale = layOut().scale;
    if (!scale.frame.contains(event->position()))
        return;
    m_from = m_to = event->position();
    if (event->button() == Qt::MiddleButton ||
        (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ShiftModifier) != 0))
        m_drag = Drag::Pan;
    else if (event->button() == Qt::LeftButton)
        m_drag = cursorAt(event->position()).value_or(Drag::Box);
}

void LogChart::mouseMoveEvent(QMouseEvent* event) {
    const PlotScale scale = layOut().scale;
    const double time = scale.xAt(std::clamp(event->position().x(), scale.frame.left(), scale.frame.right()));
    m_pointer = scale.frame.contains(event->position()) ? std::optional(time) : std::nullopt;
    emit pointerMoved(m_pointer);
    const QPointF before = m_to;
    m_to = event->position();
    switch (m_drag) {
    case Drag::Pan:
        emit panRequested(scale.xAt(before.x()) - scale.xAt(m_to.x()));
        break;
    case Drag::CursorA:
        emit cursorRequested('a', time);
        break;
    case Drag::CursorB:
        emit cursorRequested('b', time);
        break;
    case Drag::Box:
        update();
        break;
    case Drag::None:
        setCursor(cursorAt(event->position()) ? Qt::SplitHCursor
                  : m_pointer                 ? Qt::CrossCursor
                                              : Qt::ArrowCursor);
        break;
    }
}

/// A click without a drag sets cursor A, with Control cursor B.
void LogChart::mouseReleaseEvent(QMouseEvent* event) {
    const Drag drag = m_drag;
    m_drag = Drag::None;
    m_to = event->position();
    if (drag != Drag::Box)
        return;
    if (std::abs(m_to.x() - m_from.x()) >= kLeastBox)
        endBox();
    else
        emit cursorRequested((event->modifiers() & Qt::ControlModifier) != 0 ? 'b' : 'a',
                             layOut().scale.xAt(m_from.x()));
    update();
}

void LogChart::leaveEvent(QEvent* event) {
    m_pointer.reset();
    emit pointerMoved(std::nullopt);
    QWidget::leaveEvent(event);
}

void LogChart::contextMenuEvent(QContextMenuEvent* event) {
    emit menuRequested(event->globalPos());
}

void LogChart::focusInEvent(QFocusEvent* event) {
    invalidate();
    emit entered();
    QWidget::focusInEvent(event);
}

void LogChart::focusOutEvent(QFocusEvent* event) {
    invalidate();
    QWidget::focusOutEvent(event);
}

void LogChart::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(QString::fromLatin1(kColumnsMime)))
        event->acceptProposedAction();
}

void LogChart::dropEvent(QDropEvent* event) {
    const QByteArray names = event->mimeData()->data(QString::fromLatin1(kColumnsMime));
    emit columnsDropped(QString::fromUtf8(names).split(QLatin1Char('\n'), Qt::SkipEmptyParts));
    event->acceptProposedAction();
}

} // namespace hexapose

#include "moc_log_chart.cpp"
