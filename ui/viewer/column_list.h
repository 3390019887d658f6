// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table.h"
#include "ui/common/card.h"

#include <QStringList>

#include <memory>

class QLineEdit;
class QListWidget;
class QPushButton;

namespace hexapose {

/// The columns of a log, to be dragged onto a chart, or added by keys and buttons.
class ColumnList final : public Card {
    Q_OBJECT
public:
    explicit ColumnList(QWidget* parent = nullptr);
    void showTable(const Table& table);

signals:
    void addRequested(const QStringList& columns); ///< to the present chart
    void newChartRequested(const QStringList& columns);

protected:
    void changeEvent(QEvent* event) override;

private:
    QStringList chosen() const;
    void filter();
    void enableButtons();
    void retranslate();

    QStringList m_names; ///< that are shown
    QLineEdit* m_filter;
    QListWidget* m_list;
    QPushButton* m_add;
    QPushButton* m_newChart;
};

} // namespace hexapose
