// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/column_list.h"

#include "ui/common/labelled.h"
#include "ui/viewer/log_chart.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>

namespace hexapose {

namespace {

/// What is dragged are the names of columns.
class DragList final : public QListWidget {
public:
    using QListWidget::QListWidget;

protected:
    QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override {
        QStringList names;
        for (const QListWidgetItem* item : items)
            names.append(item->text());
        auto* dragged = new QMimeData;
        dragged->setData(QString::fromLatin1(kColumnsMime), names.join(QLatin1Char('\n')).toUtf8());
        return dragged;
    }
};

} // namespace

ColumnList::ColumnList(QWidget* parent)
    : Card(parent), m_filter(new QLineEdit(this)), m_list(new DragList(this)), m_add(new QPushButton(this)),
      m_newChart(new QPushButton(this)) {
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setDragEnabled(true);
    m_list->setUniformItemSizes(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_filter->setClearButtonEnabled(true);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    buttons->addWidget(m_add, 1);
    buttons->addWidget(m_newChart, 1);
    body()->addWidget(m_filter);
    body()->addWidget(m_list, 1);
    body()->addLayout(buttons);
    connect(m_filter, &QLineEdit::textChanged, this, &ColumnList::filter);
    connect(m_list, &QListWidget::itemSelectionChanged, this, &ColumnList::enableButtons);
    connect(m_list, &QListWidget::itemActivated, this, [this] { emit addRequested(chosen()); });
    connect(m_add, &QPushButton::clicked, this, [this] { emit addRequested(chosen()); });
    connect(m_newChart, &QPushButton::clicked, this, [this] { emit newChartRequested(chosen()); });
    retranslate();
    enableButtons();
}

void ColumnList::showTable(const Table& table) {
    QStringList names;
    for (const Column& column : table.columns())
        names.append(QString::fromStdString(column.info().name));
    if (names == m_names)
        return;
    m_names = names;
    m_list->clear();
    for (const Column& column : table.columns()) {
        auto* item = new QListWidgetItem(QString::fromStdString(column.info().name), m_list);
        if (!column.isNumber()) // nothing to draw
            item->setFlags(Qt::NoItemFlags);
        item->setData(Qt::UserRole, column.isNumber());
    }
    filter();
    retranslate();
}

QStringList ColumnList::chosen() const {
    QStringList names;
    for (const QListWidgetItem* item : m_list->selectedItems())
        if (!item->isHidden())
            names.append(item->text());
    return names;
}

void ColumnList::filter() {
    for (int i = 0; i < m_list->count(); ++i)
        m_list->item(i)->setHidden(!m_list->item(i)->text().contains(m_filter->text(), Qt::CaseInsensitive));
    enableButtons();
}

void ColumnList::enableButtons() {
    const bool any = !chosen().isEmpty();
    m_add->setEnabled(any);
    m_newChart->setEnabled(any);
}

void ColumnList::retranslate() {
    setTitle(tr("Columns"));
    m_list->setAccessibleName(tr("Column list"));
    m_filter->setAccessibleName(tr("Filter columns"));
    m_filter->setPlaceholderText(tr("Filter"));
    label(*m_add, tr("Add"), tr("Add to chart"), tr("Add the chosen columns to the present chart"));
    label(*m_newChart, tr("New chart"), tr("New chart"),
          tr("Show the chosen columns in a chart of their own"));
    for (int i = 0; i < m_list->count(); ++i)
        if (!m_list->item(i)->data(Qt::UserRole).toBool())
            m_list->item(i)->setToolTip(tr("Not numbers: states and events are marked in every chart"));
}

void ColumnList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    Card::changeEvent(event);
}

} // namespace hexapose

#include "moc_column_list.cpp"
