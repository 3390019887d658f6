// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kinematics/platform_model.h"
#include "core/record/snapshot.h"
#include "ui/charts/chart_history.h"
#include "ui/charts/time_chart.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <optional>

class QButtonGroup;
class QLabel;
class QPushButton;

namespace hexapose {

/// Six charts in two rows and what they show: the pose, the legs, or the errors of the pose.
class ChartPage final : public QWidget {
    Q_OBJECT
public:
    enum class Subject { Pose, Legs, Errors };

    explicit ChartPage(SharedModel model, QWidget* parent = nullptr);
    void setColors(const ThemeColors& colors);
    /// Takes fresh measurements in; stale stretches become gaps.
    void add(const Snapshot& snapshot);
    void clear();
    /// Draws all at once. `now`: session time, s.
    void refresh(double now);
    /// Draws one chart after the other, so that a key, Stop's above all, never waits for more than one. What
    /// is still to be drawn when it is called again is drawn first.
    void refreshInTurn(double now);

    void setSubject(Subject subject);
    Subject subject() const { return m_subject; }
    double window() const { return m_window; } ///< s
    bool isPaused() const { return m_frozen.has_value(); }
    const ChartHistory& history() const { return m_history; }
    const std::array<TimeChart*, 6>& charts() const { return m_charts; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void setPaused(bool paused);
    void zoom(double factor);
    void applySubject();
    void retranslate();
    void draw();
    void draw(TimeChart& chart);
    void drawNext();
    ChartSubject describe(std::size_t index) const;

    SharedModel m_model;
    ChartHistory m_history;
    std::optional<ChartHistory> m_frozen; ///< what a paused page shows
    std::array<TimeChart*, 6> m_charts{};
    Subject m_subject = Subject::Pose;
    double m_window;
    double m_now = 0.0;
    QTimer m_turn;
    std::size_t m_nextChart = 0; ///< to be drawn in its turn
    std::optional<double> m_cursor;
    bool m_gap = true;
    QButtonGroup* m_subjects;
    QPushButton* m_pose;
    QPushButton* m_legs;
    QPushButton* m_errors;
    QPushButton* m_pause;
    QPushButton* m_zoomIn;
    QPushButton* m_zoomOut;
    QLabel* m_legend;
    ThemeColors m_colors;
};

} // namespace hexapose
