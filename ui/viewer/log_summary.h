// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table_loader.h"
#include "ui/common/card.h"

class QProgressBar;
class QPushButton;

namespace hexapose {

class ReadOut;
class TextReadOut;

/// How much there is in a log, and how far it has been read.
class LogSummary final : public Card {
    Q_OBJECT
public:
    explicit LogSummary(QWidget* parent = nullptr);
    void showLog(const QString& name, const Table& table, const LoadProgress& progress);
    void showNothing();

signals:
    void cancelRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void showProgress(const LoadProgress& progress);
    void retranslate();

    QString m_name;
    LoadProgress m_progress;
    QLabel* m_captions[3];
    ReadOut* m_rows;
    ReadOut* m_columns;
    ReadOut* m_span;
    QProgressBar* m_bar;
    QPushButton* m_cancel;
    TextReadOut* m_state;
};

} // namespace hexapose
