// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <optional>

namespace hexapose {

/// Where a leg stands within its stroke: filled to the measured length, a tick at the commanded one.
class LegBar final : public QWidget {
    Q_OBJECT
public:
    explicit LegBar(QWidget* parent = nullptr);
    void setStroke(double low, double high);
    void setLengths(std::optional<double> measured, std::optional<double> commanded, bool stale);
    QSize sizeHint() const override { return {110, 12}; }
    QSize minimumSizeHint() const override { return {60, 12}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double part(double length) const; ///< 0..1 of the stroke
    double m_low = 0.0;
    double m_high = 1.0;
    std::optional<double> m_measured;
    std::optional<double> m_commanded;
    bool m_stale = false;
};

} // namespace hexapose
