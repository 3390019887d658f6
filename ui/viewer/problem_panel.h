// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table.h"
#include "ui/common/card.h"

#include <memory>

class QListView;

namespace hexapose {

class ProblemModel;
class TextReadOut;

/// What is wrong with a file: line, column and cause, and on a click the line as it stands there.
class ProblemPanel final : public Card {
    Q_OBJECT
public:
    explicit ProblemPanel(QWidget* parent = nullptr);
    void showProblems(const std::shared_ptr<const Table>& table, const QString& file);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showLine(int row);
    void retranslate();

    std::shared_ptr<const Table> m_table;
    QString m_file;
    ProblemModel* m_model;
    QLabel* m_count;
    QListView* m_list;
    TextReadOut* m_line;
};

/// One problem in the language of the screen: "line 12, l3_mm: ...".
QString problemText(const Problem& problem);

} // namespace hexapose
