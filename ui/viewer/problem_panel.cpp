// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/problem_panel.h"

#include "core/base/input_error.h"
#include "ui/common/read_out.h"
#include "ui/viewer/row_text.h"

#include <QAbstractListModel>
#include <QEvent>
#include <QListView>
#include <QVBoxLayout>

namespace hexapose {

/// The problems of a table as rows.
class ProblemModel final : public QAbstractListModel {
public:
    using QAbstractListModel::QAbstractListModel;

    void show(const std::shared_ptr<const Table>& table) {
        const std::size_t before = count();
        const bool isSame = m_table && table && m_table->sourceName() == table->sourceName();
        const std::size_t after = table ? table->problems().first.size() : 0;
        if (isSame && after == before) {
            m_table = table;
            return;
        }
        beginResetModel();
        m_table = table;
        endResetModel();
    }
    const Problem& problem(int row) const { return m_table->problems().first[static_cast<std::size_t>(row)]; }
    int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : static_cast<int>(count());
    }
    QVariant data(const QModelIndex& index, int role) const override {
        return role == Qt::DisplayRole || role == Qt::ToolTipRole ? problemText(problem(index.row()))
                                                                  : QVariant();
    }

private:
    std::size_t count() const { return m_table ? m_table->problems().first.size() : 0; }

    std::shared_ptr<const Table> m_table;
};

ProblemPanel::ProblemPanel(QWidget* parent)
    : Card(parent), m_table(std::make_shared<Table>()), m_model(new ProblemModel(this)),
      m_count(makeMutedLabel(this)), m_list(new QListView(this)), m_line(new TextReadOut(2, this)) {
    m_list->setModel(m_model);
    m_list->setUniformItemSizes(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // the tip has the whole text
    m_list->setMinimumHeight(44);
    m_line->setLineWrapMode(QTextEdit::NoWrap);
    m_line->hide();
    body()->addWidget(m_count);
    body()->addWidget(m_list, 1);
    body()->addWidget(m_line);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& index) { showLine(index.isValid() ? index.row() : -1); });
    connect(m_list, &QListView::clicked, this, [this](const QModelIndex& index) { showLine(index.row()); });
    retranslate();
}

void ProblemPanel::showProblems(const std::shared_ptr<const Table>& table, const QString& file) {
    if (file != m_file)
        showLine(-1);
    m_table = table;
    m_file = file;
    m_model->show(table);
    retranslate();
}

void ProblemPanel::showLine(int row) {
    const long line = row < 0 ? 0 : m_model->problem(row).line;
    m_line->setVisible(line > 0);
    if (line <= 0)
        return;
    try {
        m_line->showText(QString::fromStdString(textOfLine(m_file.toStdString(), *m_table, line)));
    } catch (const InputError& error) {
        m_line->showText(QString::fromUtf8(error.what()));
    }
}

void ProblemPanel::retranslate() {
    const ProblemList& problems = m_table->problems();
    setTitle(problems.isEmpty() ? tr("Problems: none") : tr("Problems: %1").arg(problems.count));
    m_count->setVisible(!problems.isEmpty());
    m_count->setText(tr("%1 rows left out, %2 cells missing")
                         .arg(QString::number(problems.rowsLeftOut), QString::number(problems.cellsMissing)));
    m_list->setAccessibleName(tr("Problems"));
    m_line->setAccessibleName(tr("Text of the line"));
}

void ProblemPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    Card::changeEvent(event);
}

} // namespace hexapose

#include "moc_problem_panel.cpp"
