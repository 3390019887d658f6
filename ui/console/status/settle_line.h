// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/machine/control_loop.h"
#include "core/record/snapshot.h"

#include <QWidget>

class QLabel;

namespace hexapose {

class ReadOut;

/// Whether the platform is where it was sent, with the window and the time that this means.
class SettleLine final : public QWidget {
    Q_OBJECT
public:
    explicit SettleLine(const SharedModel& model, QWidget* parent = nullptr);
    void setControl(const ControlOptions& options);
    void add(const Snapshot& snapshot); ///< every one: the event must not be missed
    void showSnapshot(const Snapshot& snapshot);

protected:
    void changeEvent(QEvent* event) override;

private:
    QString windowText() const;
    void refresh();

    SharedModel m_model;
    ControlOptions m_control; ///< complete
    RunState m_state = RunState::Disconnected;
    MotionMode m_mode = MotionMode::Joint;
    bool m_stale = true;
    bool m_settled = false;
    QLabel* m_lamp;
    ReadOut* m_text;
};

} // namespace hexapose
