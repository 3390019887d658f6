// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/record/snapshot.h"

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QSlider;

namespace hexapose {

class ReadOut;

/// The operator's speed override, 5 to 100 %; it says so while a motion is held on its path.
class SpeedControl final : public QWidget {
    Q_OBJECT
public:
    explicit SpeedControl(QWidget* parent = nullptr);

    /// What the loop should have, 0..1.
    double speedOverride() const;
    /// Sends the override again where the loop has another: it may be a new loop, or a stop may have swept
    /// the command away.
    void showSnapshot(const Snapshot& snapshot);
    void sendOverride();

signals:
    void overrideRequested(double speedOverride);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showOverride();
    void retranslate();

    QLabel* m_label;
    QSlider* m_slider;
    ReadOut* m_readOut;
    QElapsedTimer m_sinceSent;
    bool m_held = false;
};

} // namespace hexapose
