// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kinematics/platform_model.h"
#include "core/record/snapshot.h"
#include "ui/common/card.h"

#include <array>

class QGridLayout;

namespace hexapose {

class LegBar;
class ReadOut;
class SettleLine;

/// The six legs: commanded, measured, error, where each stands within its stroke, and whether they have
/// settled.
class LegsPanel final : public Card {
    Q_OBJECT
public:
    explicit LegsPanel(const SharedModel& model, QWidget* parent = nullptr);
    void showSnapshot(const Snapshot& snapshot);
    SettleLine& settleLine() { return *m_settle; }

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        ReadOut* commanded;
        ReadOut* measured;
        ReadOut* error;
        LegBar* bar;
    };
    void addRow(QGridLayout& grid, int leg);
    void retranslate();

    SharedModel m_model;
    std::array<Row, kLegCount> m_rows{};
    std::array<QLabel*, 4> m_heads{};
    SettleLine* m_settle;
};

} // namespace hexapose
