// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/log_summary.h"

#include "core/base/number_text.h"
#include "ui/common/labelled.h"
#include "ui/common/read_out.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace hexapose {

namespace {

constexpr double kBytesOfMegabyte = 1e6;
constexpr int kBarSteps = 1000;

QString megabytes(std::uint64_t bytes) {
    return QString::fromStdString(formatFixed(static_cast<double>(bytes) / kBytesOfMegabyte, 1));
}

/// Without the folder, which has no room here.
QString errorText(const QString& name, const std::string& error) {
    const QString text = QString::fromStdString(error);
    const qsizetype at = text.indexOf(name);
    return at >= 0 ? text.mid(at) : text;
}

QString spanText(const Table& table) {
    if (table.rowCount() == 0)
        return ReadOut::dash();
    const double length = table.time().end() - table.time().begin();
    if (!table.time().hasTime())
        return LogSummary::tr("%1 rows").arg(table.rowCount());
    return QString::fromStdString(formatFixed(length, 3)) + QStringLiteral(" s");
}

} // namespace

LogSummary::LogSummary(QWidget* parent)
    : Card(parent), m_rows(new ReadOut(this)), m_columns(new ReadOut(this)), m_span(new ReadOut(this)),
      m_bar(new QProgressBar(this)), m_cancel(new QPushButton(this)), m_state(new TextReadOut(2, this)) {
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    int row = 0;
    for (ReadOut* readOut : {m_rows, m_columns, m_span}) {
        readOut->setFocusPolicy(Qt::StrongFocus);
        m_captions[row] = makeMutedLabel(this);
        grid->addWidget(m_captions[row], row, 0);
        grid->addWidget(readOut, row, 1);
        ++row;
    }
    auto* loading = new QHBoxLayout;
    loading->addWidget(m_bar, 1);
    loading->addWidget(m_cancel);
    m_bar->setRange(0, kBarSteps);
    body()->addLayout(grid);
    body()->addLayout(loading);
    body()->addWidget(m_state);
    connect(m_cancel, &QPushButton::clicked, this, &LogSummary::cancelRequested);
    showNothing();
}

void LogSummary::showNothing() {
    for (ReadOut* readOut : {m_rows, m_columns, m_span})
        readOut->showText(ReadOut::dash());
    m_progress = {};
    m_progress.isDone = true;
    retranslate();
    setTitle(tr("No log"));
    m_state->showText(tr("Open a log, or drop one here."));
    m_state->show();
}

void LogSummary::showLog(const QString& name, const Table& table, const LoadProgress& progress) {
    m_name = name;
    setTitle(name);
    m_rows->showText(QString::number(table.rowCount()));
    m_columns->showText(QString::number(table.columns().size()));
    m_span->showText(spanText(table));
    m_progress = progress;
    showProgress(progress);
}

void LogSummary::showProgress(const LoadProgress& progress) {
    m_bar->setVisible(!progress.isDone);
    m_cancel->setVisible(!progress.isDone);
    if (progress.bytesInAll > 0)
        m_bar->setValue(static_cast<int>(kBarSteps * (static_cast<double>(progress.bytesRead) /
                                                      static_cast<double>(progress.bytesInAll))));
    QString state;
    if (!progress.isDone)
        state = tr("%1 of %2 MB, %3 rows")
                    .arg(megabytes(progress.bytesRead), megabytes(progress.bytesInAll))
                    .arg(m_rows->text());
    else if (progress.error)
        state = errorText(m_name, *progress.error);
    else if (progress.isCancelled)
        state = tr("Cancelled: only the first part was read");
    m_state->showText(state);
    m_state->setToolTip(state);
    m_state->setVisible(!state.isEmpty());
}

void LogSummary::retranslate() {
    const QString names[] = {tr("Rows"), tr("Columns"), tr("Time span")};
    ReadOut* const readOuts[] = {m_rows, m_columns, m_span};
    for (int i = 0; i < 3; ++i) {
        setCaption(*m_captions[i], names[i]);
        readOuts[i]->setAccessibleName(names[i]);
    }
    m_bar->setAccessibleName(tr("Progress"));
    m_state->setAccessibleName(tr("Reading"));
    label(*m_cancel, tr("Cancel"), tr("Stop reading and keep what there is"));
    showProgress(m_progress);
}

void LogSummary::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    Card::changeEvent(event);
}

} // namespace hexapose

#include "moc_log_summary.cpp"
