// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/pose.h"

#include <QPointer>
#include <QTableWidget>

#include <optional>
#include <vector>

namespace hexapose {

class NumberField;

/// Poses to be visited, one a row, in mm and degrees. A cell keeps what is typed, as a NumberField does;
/// whether that is understood poseAt() says.
class WayPointTable final : public QTableWidget {
    Q_OBJECT
public:
    explicit WayPointTable(QWidget* parent = nullptr);

    void setPoses(const std::vector<Pose>& poses);
    void append(const Pose& pose);
    /// Nothing where a cell of the row is refused.
    std::optional<Pose> poseAt(int row) const;
    /// The first cell that is refused, and why.
    struct Refusal {
        int row;
        int coordinate; ///< 0..5
        QString reason;
    };
    std::optional<Refusal> refusal() const;
    /// Takes what stands in an open editor, as if it had been left.
    void finishEditing();
    void removeCurrent();
    void moveCurrent(int by); ///< -1: up, 1: down
    /// The row that is being visited; -1: none. It stays in sight.
    void mark(int row);
    int marked() const { return m_marked; }
    void setEditable(bool editable);

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QString textAt(int row, int column) const;
    void writeRow(int row, const Pose& pose);
    void paintRow(int row);
    void numberRows();
    void fitColumns();

    int m_marked = -1;
    QPointer<NumberField> m_editor; ///< of the cell that is being edited
};

} // namespace hexapose
