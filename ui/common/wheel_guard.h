// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace hexapose {

/// As long as it lives the mouse wheel changes no control of the program that has not got the focus: box,
/// slider, spin box or tab bar, and gives the focus to none. What surrounds the control scrolls in its place.
class WheelGuard final : public QObject {
    Q_OBJECT
public:
    explicit WheelGuard(QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace hexapose
