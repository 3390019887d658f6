// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/error_report.h"
#include "ui/common/job.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <optional>

namespace hexapose {

/// Draws and writes the report's files on a thread of its own, so that no key waits for it, Stop least of
/// all. The signals come on the thread of this object. Asked again while it writes, it writes the newest
/// afterwards.
class ReportWriter final : public QObject {
    Q_OBJECT
public:
    explicit ReportWriter(QObject* parent = nullptr);

    void write(const ErrorReport& report, const QString& folder);

signals:
    void written(const QStringList& files, const QString& folder);
    void failed(const QString& reason);

private:
    struct Task {
        ErrorReport report;
        QString folder;
    };
    void start(Task task);

    std::optional<Task> m_next;
    Job m_job; ///< last, so that the files that are being written are waited for first
};

} // namespace hexapose
