// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/pose.h"

#include <QTableWidget>

#include <optional>
#include <vector>

namespace hexapose {

/// Poses to be visited, one a row, in mm and degrees. A cell takes what is typed; whether that is a number
/// poseAt() says.
class WayPointTable final : public QTableWidget {
    Q_OBJECT
public:
    explicit WayPointTable(QWidget* parent = nullptr);

    void setPoses(const std::vector<Pose>& poses);
    void append(const Pose& pose);
    /// Nothing where a cell of the row is no number.
    std::optional<Pose> poseAt(int row) const;
    /// The first coordinate (0..5) of a row that is no number; -1 for none.
    int wrongCoordinate(int row) const;
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
    std::optional<double> numberAt(int row, int column) const;
    void writeRow(int row, const Pose& pose);
    void paintRow(int row);
    void fitColumns();

    int m_marked = -1;
};

} // namespace hexapose
