// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/error_report.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>

class QThread;

namespace hexapose {

/// Draws and writes the report's files on a thread of its own, so that no key waits for it, Stop least of
/// all. The signals come on the thread of this object. Asked again while it writes, it writes the newest
/// afterwards.
class ReportWriter final : public QObject {
    Q_OBJECT
public:
    explicit ReportWriter(QObject* parent = nullptr);
    ~ReportWriter() override; ///< waits for the files that are being written

    void write(const ErrorReport& report, const QString& folder);

signals:
    void written(const QStringList& files, const QString& folder);
    void failed(const QString& reason);

private:
    struct Job {
        ErrorReport report;
        QString folder;
    };
    void start(Job job);
    void finish();

    std::unique_ptr<QThread> m_thread;
    std::optional<Job> m_next;
};

} // namespace hexapose
