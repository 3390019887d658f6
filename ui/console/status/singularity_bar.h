// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/common/theme.h"

#include <QWidget>

#include <optional>

namespace hexapose {

/// q, the determinant of the scaled Jacobian over that at home: 1 at home, 0 singular, below 0 on the other
/// side. Below the first bound it is amber, below the second red.
inline constexpr double kCautionQ = 0.2;
inline constexpr double kDangerQ = 0.05;
Tone toneOfQ(std::optional<double> q);

/// How far from singular the platform is, from 0 to 1, with the two zones marked on the track.
class SingularityBar final : public QWidget {
    Q_OBJECT
public:
    explicit SingularityBar(QWidget* parent = nullptr);
    void setValue(std::optional<double> q, bool stale);
    QSize sizeHint() const override { return {110, 14}; }
    QSize minimumSizeHint() const override { return {60, 14}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<double> m_q;
    bool m_stale = false;
};

} // namespace hexapose
