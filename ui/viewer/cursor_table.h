// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewer/chart_sheet.h"
#include "ui/viewer/cursor_numbers.h"

#include <QScrollArea>
#include <QTimer>

#include <array>
#include <vector>

class QGridLayout;
class QLabel;

namespace hexapose {

class ReadOut;

/// For every curve of a page: its values at the cursors, and what lies between them.
class CursorTable final : public QScrollArea {
    Q_OBJECT
public:
    explicit CursorTable(QWidget* parent = nullptr);
    /// Null for none.
    void follow(ChartSheet* sheet);
    void setColors(ThemeKind theme);

protected:
    void changeEvent(QEvent* event) override;

private:
    static constexpr int kNumbers = 9; ///< A, B, difference, mean, sigma, RMS, minimum, maximum, count
    struct Line {
        CurveSpec spec;
        QLabel* name;
        std::array<ReadOut*, kNumbers> numbers;
    };

    void refresh();
    void makeLines(const std::vector<CurveSpec>& curves);
    void showStatistics(const std::vector<Statistics>& statistics, const std::vector<Curve>& curves);
    void widen();
    void retranslate();

    ChartSheet* m_sheet = nullptr;
    ThemeKind m_theme = ThemeKind::Light;
    NumbersJob* m_job;
    QTimer m_delay;
    QFrame* m_content;
    QGridLayout* m_grid;
    QLabel* m_curve;
    std::array<QLabel*, kNumbers> m_heads{};
    std::array<int, kNumbers> m_digits{}; ///< that a number of each column has room for
    std::vector<Line> m_lines;
    std::vector<QColor> m_colours;
};

} // namespace hexapose
