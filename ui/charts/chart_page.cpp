// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart_page.h"

#include "core/base/units.h"
#include "ui/common/labelled.h"
#include "ui/common/status_text.h"

#include <QButtonGroup>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapose {

namespace {

constexpr int kTurnMs = 3;       ///< between one chart and the next: what waits meanwhile comes first
constexpr double kWindow = 10.0; // s, as Figure 7 shows some seconds
constexpr double kLeastWindow = 1.0;
constexpr double kLargestWindow = 120.0;
constexpr double kOffsetRange = 40.0; // mm and degrees of Figure 7
constexpr double kAngleRange = 10.0;
constexpr double kErrorRange = 0.5;

// Channels: measured pose, target pose, measured lengths, commanded lengths, pose error.
constexpr std::size_t kMeasured = 0;
constexpr std::size_t kTarget = 6;
constexpr std::size_t kLeg = 12;
constexpr std::size_t kLegTarget = 18;
constexpr std::size_t kError = 24;
constexpr std::size_t kChannels = 30;

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

void putPose(std::vector<double>& values, std::size_t channel, const std::optional<Pose>& pose) {
    if (!pose) {
        return;
    }
    const PoseVector si = pose->toVector();
    for (int i = 0; i < 6; ++i) {
        values[channel + static_cast<std::size_t>(i)] = toDisplay(i, si[i]);
    }
}

void putLengths(std::vector<double>& values, std::size_t channel, const std::optional<LegLengths>& lengths) {
    for (int i = 0; lengths && i < kLegCount; ++i) {
        values[channel + static_cast<std::size_t>(i)] = mmFromMetres((*lengths)[i]);
    }
}

std::vector<double> channelValues(const Snapshot& snapshot) {
    std::vector<double> values(kChannels, std::numeric_limits<double>::quiet_NaN());
    putPose(values, kMeasured, snapshot.measuredPose);
    putPose(values, kTarget, snapshot.targetPose);
    putLengths(values, kLeg, snapshot.measuredLengths);
    putLengths(values, kLegTarget, snapshot.commandedLengths);
    if (snapshot.measuredPose && snapshot.targetPose) {
        const PoseVector measured = snapshot.measuredPose->toVector();
        const PoseVector target = snapshot.targetPose->toVector();
        for (int i = 0; i < 6; ++i) {
            values[kError + static_cast<std::size_t>(i)] = displayError(i, measured[i], target[i]);
        }
    }
    return values;
}

QPushButton* makeToggle(QButtonGroup& group, int id, QWidget* parent) {
    auto* button = new QPushButton(parent);
    button->setCheckable(true);
    group.addButton(button, id);
    return button;
}

} // namespace

ChartPage::ChartPage(SharedModel model, QWidget* parent)
    : QWidget(parent), m_model(std::move(model)), m_history(kChannels), m_window(kWindow),
      m_colors(themeColors(ThemeKind::Light)) {
    m_turn.setInterval(kTurnMs);
    connect(&m_turn, &QTimer::timeout, this, &ChartPage::drawNext);
    build();
    setColors(m_colors);
    retranslate();
}

void ChartPage::build() {
    m_subjects = new QButtonGroup(this);
    m_pose = makeToggle(*m_subjects, 0, this);
    m_legs = makeToggle(*m_subjects, 1, this);
    m_errors = makeToggle(*m_subjects, 2, this);
    m_pose->setChecked(true);
    // Toggled and not clicked: a screen reader toggles.
    connect(m_subjects, &QButtonGroup::idToggled, this, [this](int id, bool on) {
        if (on) {
            setSubject(static_cast<Subject>(id));
        }
    });
    m_pause = new QPushButton(this);
    m_pause->setCheckable(true);
    connect(m_pause, &QPushButton::toggled, this, &ChartPage::setPaused);
    m_zoomIn = new QPushButton(QStringLiteral("+"), this);
    m_zoomOut = new QPushButton(QString::fromUtf8("\u2212"), this);
    connect(m_zoomIn, &QPushButton::clicked, this, [this] { zoom(0.5); });
    connect(m_zoomOut, &QPushButton::clicked, this, [this] { zoom(2.0); });
    m_legend = new QLabel(this);
    m_legend->setTextFormat(Qt::RichText);

    auto* bar = new QHBoxLayout;
    bar->setSpacing(6);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_pose, m_legs, m_errors}) {
        bar->addWidget(widget);
    }
    bar->addStretch(1);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_legend, m_zoomOut, m_zoomIn, m_pause}) {
        bar->addWidget(widget);
    }
    auto* grid = new QGridLayout;
    grid->setSpacing(8);
    for (std::size_t i = 0; i < m_charts.size(); ++i) {
        m_charts[i] = new TimeChart(this);
        grid->addWidget(m_charts[i], static_cast<int>(i) / 3, static_cast<int>(i) % 3);
        connect(m_charts[i], &TimeChart::zoomed, this, &ChartPage::zoom);
        connect(m_charts[i], &TimeChart::cursorMoved, this, [this](double time) {
            m_cursor = time;
            draw();
        });
        connect(m_charts[i], &TimeChart::cursorLeft, this, [this] {
            m_cursor.reset();
            draw();
        });
    }
    auto* page = new QVBoxLayout(this);
    page->setContentsMargins(0, 0, 0, 0);
    page->setSpacing(8);
    page->addLayout(bar);
    page->addLayout(grid, 1);
}

void ChartPage::setColors(const ThemeColors& colors) {
    m_colors = colors;
    for (TimeChart* chart : m_charts) {
        chart->setColors(colors);
    }
    retranslate();
}

void ChartPage::add(const Snapshot& snapshot) {
    if (snapshot.fresh && !snapshot.stale) {
        m_history.add(seconds(snapshot.time), channelValues(snapshot));
        m_gap = false;
    } else if (snapshot.stale && !m_gap) {
        m_history.addGap();
        m_gap = true;
    }
}

void ChartPage::clear() {
    m_history.clear();
    m_gap = true;
    m_now = 0.0;
    m_pause->setChecked(false);
    draw();
}

void ChartPage::refresh(double now) {
    if (!m_frozen) {
        m_now = now;
        draw();
    }
}

void ChartPage::refreshInTurn(double now) {
    if (m_frozen || m_turn.isActive()) {
        return;
    }
    m_now = now;
    m_nextChart = 0;
    drawNext();
    m_turn.start();
}

void ChartPage::drawNext() {
    if (m_frozen || !isVisible() || m_nextChart >= m_charts.size()) {
        m_turn.stop();
        return;
    }
    draw(*m_charts[m_nextChart++]);
}

void ChartPage::draw() {
    if (!isVisible()) {
        return;
    }
    for (TimeChart* chart : m_charts) {
        draw(*chart);
    }
}

void ChartPage::draw(TimeChart& chart) {
    const ChartHistory& shown = m_frozen ? *m_frozen : m_history;
    const double to = std::max(m_now, m_window);
    chart.showWindow(shown, to - m_window, to);
    chart.showCursor(shown, m_cursor);
}

void ChartPage::setPaused(bool paused) {
    m_frozen = paused ? std::optional(m_history) : std::nullopt;
    retranslate();
    draw();
}

void ChartPage::zoom(double factor) {
    m_window = std::clamp(m_window * factor, kLeastWindow, kLargestWindow);
    draw();
}

void ChartPage::setSubject(Subject subject) {
    m_subject = subject;
    m_subjects->button(static_cast<int>(subject))->setChecked(true);
    retranslate();
    draw();
}

ChartSubject ChartPage::describe(std::size_t index) const {
    const CoordinateText& coordinate = coordinateTexts()[index];
    const int decimals = coordinate.angle ? 4 : 3;
    const double reach = coordinate.angle ? kAngleRange : kOffsetRange;
    switch (m_subject) {
    case Subject::Legs: {
        const Leg& leg = m_model->geometry().legs[index];
        return {tr("Leg %1").arg(index + 1),
                QStringLiteral("mm"),
                kLeg + index,
                kLegTarget + index,
                mmFromMetres(leg.minLength),
                mmFromMetres(leg.maxLength),
                3};
    }
    case Subject::Errors:
        return {tr("Error of %1").arg(coordinate.symbol),
                coordinate.unit,
                kError + index,
                std::nullopt,
                -kErrorRange,
                kErrorRange,
                4};
    case Subject::Pose:
        break;
    }
    return {coordinate.symbol, coordinate.unit, kMeasured + index, kTarget + index, -reach, reach, decimals};
}

void ChartPage::applySubject() {
    for (std::size_t i = 0; i < m_charts.size(); ++i) {
        m_charts[i]->setSubject(describe(i));
        m_charts[i]->setTimeTitle(tr("Time, s"));
    }
}

void ChartPage::retranslate() {
    label(*m_pose, tr("Pose"));
    label(*m_legs, tr("Legs"));
    label(*m_errors, tr("Errors"));
    label(*m_pause, isPaused() ? tr("Resume") : tr("Pause"));
    m_zoomIn->setAccessibleName(tr("Shorter time window"));
    m_zoomIn->setToolTip(m_zoomIn->accessibleName());
    m_zoomOut->setAccessibleName(tr("Longer time window"));
    m_zoomOut->setToolTip(m_zoomOut->accessibleName());
    const QString measured = QStringLiteral("<span style='color:%1'>\u2014\u2014</span> %2");
    QString legend = measured.arg(m_colors.accent.name(), tr("measured"));
    if (m_subject != Subject::Errors) {
        legend += QStringLiteral(" &nbsp; <span style='color:%1'>- - -</span> %2")
                      .arg(m_colors.muted.name(), m_subject == Subject::Legs ? tr("set-point") : tr("path"));
    }
    m_legend->setText(legend);
    applySubject();
}

void ChartPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        draw();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_chart_page.cpp"
