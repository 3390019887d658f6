// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace hexapose {

/// Draws an event: a dot of its tone and the time, the cause, and quietly what to do.
class EventDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    enum Role { TimeRole = Qt::UserRole, CauseRole, AdviceRole, ToneRole };
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace hexapose
