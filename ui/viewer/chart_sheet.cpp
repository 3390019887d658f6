// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/chart_sheet.h"

#include <QEvent>
#include <QKeyEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kKeyZoom = 0.5;
constexpr double kLeastRows = 1e-3; ///< of the usual step: further in there is nothing to see
constexpr double kLeastPart = 1e-12;
constexpr double kOutside = 1.0; ///< lengths of the log that a view may lie beside it

ViewHistory::Time now() {
    return std::chrono::steady_clock::now();
}

} // namespace

ChartSheet::ChartSheet(QWidget* parent)
    : QWidget(parent), m_colors(themeColors(ThemeKind::Light)), m_column(new QVBoxLayout(this)) {
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(6);
}

QSize ChartSheet::minimumSizeHint() const {
    return m_column->minimumSize();
}

void ChartSheet::setTable(const std::shared_ptr<const Table>& table) {
    m_curves.follow(table);
    m_marks.follow(*table);
    if (m_history.view().isWhole) {
        PageView view = m_history.view();
        view.time = whole();
        m_history.replace(view);
    }
    showAll();
    emit viewChanged();
}

void ChartSheet::setColors(const ThemeColors& colors, ThemeKind theme) {
    m_colors = colors;
    m_theme = theme;
    showAll();
}

void ChartSheet::setChartLayout(const ChartLayout& layout) {
    while (!m_charts.empty()) {
        delete m_charts.back().widget;
        m_charts.pop_back();
    }
    m_current = 0;
    for (const ChartSpec& spec : layout.charts) {
        m_charts.push_back({m_nextId++, spec, nullptr});
        makeWidget(m_charts.back());
    }
    layoutEdited();
}

ChartLayout ChartSheet::chartLayout() const {
    ChartLayout layout;
    for (const Entry& entry : m_charts)
        layout.charts.push_back(entry.spec);
    return layout;
}

void ChartSheet::addChart(const ChartSpec& chart) {
    m_charts.push_back({m_nextId++, chart, nullptr});
    makeWidget(m_charts.back());
    m_current = m_charts.size() - 1;
    layoutEdited();
}

void ChartSheet::removeChart(std::size_t index) {
    m_charts[index].widget->hide();
    m_charts[index].widget->deleteLater(); // its own menu may have asked
    m_charts.erase(m_charts.begin() + static_cast<std::ptrdiff_t>(index));
    m_current = std::min(m_current, m_charts.empty() ? 0 : m_charts.size() - 1);
    layoutEdited();
}

void ChartSheet::addCurve(std::size_t index, const CurveSpec& curve) {
    std::vector<CurveSpec>& curves = m_charts[index].spec.curves;
    if (std::find(curves.begin(), curves.end(), curve) != curves.end())
        return;
    curves.push_back(curve);
    layoutEdited();
}

void ChartSheet::removeCurve(std::size_t index, const CurveSpec& curve) {
    std::erase(m_charts[index].spec.curves, curve);
    layoutEdited();
}

void ChartSheet::layoutEdited() {
    for (std::size_t i = 0; i < m_charts.size(); ++i)
        m_charts[i].widget->setTimeTitleShown(i + 1 == m_charts.size());
    updateGeometry();
    showAll();
    emit layoutChanged();
}

void ChartSheet::makeWidget(Entry& entry) {
    auto* chart = new LogChart(this);
    entry.widget = chart;
    m_column->addWidget(chart, 1);
    connect(chart, &LogChart::entered, this, [this, chart] {
        if (const Entry* found = find(chart))
            m_current = static_cast<std::size_t>(found - m_charts.data());
    });
    connect(chart, &LogChart::resized, this, &ChartSheet::alignLeft); // there may be other ticks
    connect(chart, &LogChart::zoomRequested, this,
            [this](double factor, double about) { zoom(factor, about); });
    connect(chart, &LogChart::valueZoomRequested, this, [this, chart](double factor, double about) {
        if (Entry* found = find(chart))
            zoomValues(*found, factor, about);
    });
    connect(chart, &LogChart::panRequested, this, [this](double seconds) {
        const TimeSpan& shown = time();
        showTime({shown.begin + seconds, shown.end + seconds}, ViewHistory::Step::Burst);
    });
    connect(chart, &LogChart::boxRequested, this,
            [this, chart](const TimeSpan& box, const std::optional<AxisRange>& values) {
                PageView view = m_history.view();
                view.time = box;
                view.isWhole = false;
                const Entry* found = find(chart);
                if (found != nullptr && values)
                    view.values[found->id] = *values;
                showView(std::move(view), ViewHistory::Step::Single);
            });
    connect(chart, &LogChart::cursorRequested, this,
            [this](char which, double time) { setCursor(which, time); });
    connect(chart, &LogChart::columnsDropped, this, [this, chart](const QStringList& names) {
        for (const QString& name : names)
            if (const Entry* found = find(chart))
                addCurve(static_cast<std::size_t>(found - m_charts.data()), {name, {}});
    });
    connect(chart, &LogChart::menuRequested, this,
            [this, chart](QPoint position) { showMenu(*chart, position); });
}

ChartSheet::Entry* ChartSheet::find(const LogChart* widget) {
    const auto found = std::find_if(m_charts.begin(), m_charts.end(),
                                    [widget](const Entry& entry) { return entry.widget == widget; });
    return found == m_charts.end() ? nullptr : &*found;
}

void ChartSheet::showAll() {
    const PageView& view = m_history.view();
    for (const Entry& entry : m_charts) {
        const auto values = view.values.find(entry.id);
        entry.widget->showPlot({table(), &m_marks, entry.spec, m_curves.find(entry.spec), m_colors, m_theme},
                               view.time,
                               values == view.values.end() ? std::nullopt : std::optional(values->second));
    }
    alignLeft();
}

void ChartSheet::alignLeft() {
    double left = 0.0;
    for (const Entry& entry : m_charts)
        left = std::max(left, entry.widget->neededLeft());
    for (const Entry& entry : m_charts)
        entry.widget->setLeft(left);
}

TimeSpan ChartSheet::whole() const {
    const TimeAxis& axis = table()->time();
    const double begin = axis.begin(), end = axis.end();
    if (!(end > begin)) // one row, or none
        return {begin - 0.5, begin + 0.5};
    return {begin, end};
}

void ChartSheet::showView(PageView view, ViewHistory::Step step) {
    const TimeSpan all = whole();
    const double least =
        std::max({kLeastRows * table()->time().usualStep(), kLeastPart * all.length(),
                  kLeastPart * std::max(std::abs(view.time.begin), std::abs(view.time.end))});
    if (!(view.time.length() > least)) {
        const double middle = 0.5 * (view.time.begin + view.time.end);
        view.time = {middle - 0.5 * least, middle + 0.5 * least};
    }
    const double length = std::min(view.time.length(), (1.0 + 2.0 * kOutside) * all.length());
    const double lowest = all.begin - std::max(kOutside * all.length(), 0.0);
    const double highest = all.end + kOutside * all.length();
    view.time.begin = std::clamp(view.time.begin, lowest, highest - length);
    view.time.end = view.time.begin + length;
    m_history.show(view, step, now());
    showAll();
    emit viewChanged();
}

void ChartSheet::showTime(const TimeSpan& time, ViewHistory::Step step) {
    PageView view = m_history.view();
    view.time = time;
    view.isWhole = false;
    showView(std::move(view), step);
}

void ChartSheet::zoom(double factor, std::optional<double> about) {
    const TimeSpan& shown = time();
    const double fixed = about.value_or(0.5 * (shown.begin + shown.end));
    showTime({fixed + (shown.begin - fixed) * factor, fixed + (shown.end - fixed) * factor},
             ViewHistory::Step::Burst);
}

void ChartSheet::zoomValues(Entry& entry, double factor, double about) {
    PageView view = m_history.view();
    const AxisRange& shown = entry.widget->plot().y;
    view.values[entry.id] = {about + (shown.low - about) * factor, about + (shown.high - about) * factor};
    showView(std::move(view), ViewHistory::Step::Burst);
}

void ChartSheet::pan(double part) {
    const TimeSpan& shown = time();
    const double by = part * shown.length();
    showTime({shown.begin + by, shown.end + by}, ViewHistory::Step::Burst);
}

void ChartSheet::fit() {
    showView({whole(), {}, true}, ViewHistory::Step::Single);
}

void ChartSheet::goBack() {
    m_history.goBack();
    showAll();
    emit viewChanged();
}

void ChartSheet::goForward() {
    m_history.goForward();
    showAll();
    emit viewChanged();
}

void ChartSheet::setCursors(const Cursors& cursors) {
    m_cursors = cursors;
    for (const Entry& entry : m_charts)
        entry.widget->setCursors(cursors);
    emit cursorsChanged();
}

void ChartSheet::setCursor(char which, std::optional<double> time) {
    Cursors cursors = m_cursors;
    (which == 'a' ? cursors.a : cursors.b) = time;
    m_lastCursor = which;
    setCursors(cursors);
}

/// Under the pointer, else in the middle of the view.
double ChartSheet::cursorPlace() const {
    for (const Entry& entry : m_charts)
        if (const auto time = entry.widget->pointerTime())
            return *time;
    return 0.5 * (time().begin + time().end);
}

void ChartSheet::stepCursor(int rows) {
    const auto& time = m_lastCursor == 'a' ? m_cursors.a : m_cursors.b;
    const TimeAxis& axis = table()->time();
    if (table()->rowCount() == 0)
        return;
    const auto row = axis.lastAtOrBefore(time.value_or(cursorPlace()));
    const auto last = static_cast<std::ptrdiff_t>(table()->rowCount()) - 1;
    std::ptrdiff_t to = row ? static_cast<std::ptrdiff_t>(*row) + rows : 0;
    const std::ptrdiff_t on = rows < 0 ? -1 : 1;
    while (to >= 0 && to <= last && std::isnan(axis.seconds(static_cast<Row>(to))))
        to += on;
    if (to >= 0 && to <= last)
        setCursor(m_lastCursor, axis.seconds(static_cast<Row>(to)));
}

void ChartSheet::keyPressEvent(QKeyEvent* event) {
    constexpr double kKeyPan = 0.1;
    const bool byRows = (event->modifiers() & Qt::ControlModifier) != 0;
    const bool isPlain = (event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == 0;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right: {
        const int sign = event->key() == Qt::Key_Left ? -1 : 1;
        if (byRows)
            stepCursor(sign);
        else if ((event->modifiers() & Qt::AltModifier) != 0)
            sign < 0 ? goBack() : goForward();
        else
            pan(sign * kKeyPan);
        return;
    }
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(kKeyZoom);
    case Qt::Key_Minus:
        return zoom(1.0 / kKeyZoom);
    case Qt::Key_Home:
        return fit();
    case Qt::Key_Backspace:
        return goBack();
    case Qt::Key_A:
    case Qt::Key_B:
        if (isPlain)
            return setCursor(event->key() == Qt::Key_A ? 'a' : 'b', cursorPlace());
        break;
    case Qt::Key_Escape:
        if (m_cursors.a || m_cursors.b)
            return setCursors({});
        break;
    case Qt::Key_Menu:
        if (m_current < m_charts.size())
            return showMenu(*m_charts[m_current].widget,
                            m_charts[m_current].widget->mapToGlobal(QPoint(20, 20)));
        break;
    default:
        break;
    }
    QWidget::keyPressEvent(event);
}

void ChartSheet::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        showAll();
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_chart_sheet.cpp"
