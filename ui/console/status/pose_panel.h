// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kinematics/platform_model.h"
#include "core/record/snapshot.h"
#include "ui/common/card.h"

#include <array>

class QGridLayout;

namespace hexapose {

class ReadOut;
class SingularityBar;

/// The pose: that of the path, the measured one, the error, and the error that the resolution of the
/// lengths alone explains; below it how far from singular it is. Nothing is shown without a usable solution.
class PosePanel final : public Card {
    Q_OBJECT
public:
    explicit PosePanel(SharedModel model, QWidget* parent = nullptr);
    void showSnapshot(const Snapshot& snapshot);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        ReadOut* path;
        ReadOut* measured;
        ReadOut* error;
        ReadOut* expected;
    };
    void addRow(QGridLayout& grid, int coordinate);
    void addSingularity();
    void retranslate();

    SharedModel m_model;
    std::array<Row, 6> m_rows{};
    std::array<QLabel*, 4> m_heads{};
    QLabel* m_qLabel = nullptr;
    SingularityBar* m_qBar = nullptr;
    ReadOut* m_q = nullptr;
};

} // namespace hexapose
