// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/report/report_writer.h"

#include "core/base/thread_priority.h"
#include "ui/report/report_export.h"

#include <utility>

namespace hexapose {

ReportWriter::ReportWriter(QObject* parent) : QObject(parent), m_job(QStringLiteral("report")) {}

void ReportWriter::write(const ErrorReport& report, const QString& folder) {
    Task task{report, folder};
    if (m_job.isRunning()) {
        m_next = std::move(task);
        return;
    }
    start(std::move(task));
}

void ReportWriter::start(Task task) {
    const QString folder = task.folder;
    m_job.start(
        [task = std::move(task)](const Job&) {
            lowerThreadPriority(); // drawing can wait; the loop and the screen cannot
            QStringList files;
            for (const auto& file : exportErrorReport(task.report, task.folder.toStdString())) {
                files.append(QString::fromStdString(file.string()));
            }
            return files;
        },
        [this, folder](const Job::Outcome<QStringList>& outcome) {
            if (m_next) {
                start(*std::exchange(m_next, std::nullopt));
            }
            if (outcome.result) {
                emit written(*outcome.result, folder);
            } else {
                emit failed(outcome.error);
            }
        });
}

} // namespace hexapose

#include "moc_report_writer.cpp"
