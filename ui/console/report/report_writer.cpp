// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/report/report_writer.h"

#include "core/base/thread_priority.h"
#include "ui/report/report_export.h"

#include <QThread>

#include <exception>
#include <utility>

namespace hexapose {

ReportWriter::ReportWriter(QObject* parent) : QObject(parent) {}

ReportWriter::~ReportWriter() {
    if (m_thread) {
        m_thread->wait();
    }
}

void ReportWriter::write(const ErrorReport& report, const QString& folder) {
    Job job{report, folder};
    if (m_thread) {
        m_next = std::move(job);
        return;
    }
    start(std::move(job));
}

void ReportWriter::start(Job job) {
    // The signals are emitted over there and carried over to the receivers' thread.
    m_thread.reset(QThread::create([this, job = std::make_shared<const Job>(std::move(job))] {
        lowerThreadPriority(); // drawing can wait; the loop and the screen cannot
        try {
            QStringList files;
            for (const auto& file : exportErrorReport(job->report, job->folder.toStdString())) {
                files.append(QString::fromStdString(file.string()));
            }
            emit written(files, job->folder);
        } catch (const std::exception& error) {
            emit failed(QString::fromUtf8(error.what()));
        }
    }));
    m_thread->setObjectName(QStringLiteral("report"));
    connect(m_thread.get(), &QThread::finished, this, &ReportWriter::finish);
    m_thread->start();
}

void ReportWriter::finish() {
    m_thread->wait();
    m_thread.reset();
    if (m_next) {
        start(*std::exchange(m_next, std::nullopt));
    }
}

} // namespace hexapose

#include "moc_report_writer.cpp"
