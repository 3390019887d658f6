// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/visit_job.h"

#include <QObject>
#include <QPixmap>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hexapose {

/// The operator's main job without an operator: moves to the first pose, visits the others, writes a report
/// of these and a picture. Looks at the session's snapshots on a timer of its own.
class HeadlessJob final : public QObject {
    Q_OBJECT
public:
    struct Output {
        std::filesystem::path folder; ///< empty: beside the log
        std::function<QPixmap()> picture;
    };

    /// At least one target.
    HeadlessJob(const std::vector<Pose>& targets, Output output, QObject* parent = nullptr);
    /// The session is open from now on; it must outlive the job.
    void start(Session& session);
    /// Stops, disables and ends with the status of a failure.
    void interrupt();
    /// Ends with the status of a failure, for a reason of the program's own.
    void fail(const std::string& reason);

signals:
    /// The platform has nothing more to do: disconnect.
    void over();
    /// exitStatus: 0 or 1.
    void finished(int exitStatus);

private:
    void look();
    void complete();
    bool isMove(const SettledSample& sample) const;
    int write(const QPixmap& picture);

    Pose m_first; ///< where the move leads
    VisitJob m_job;
    Output m_output;
    Session* m_session = nullptr;
    SnapshotReader m_reader;
    QTimer m_timer;
    bool m_ended = false;
};

} // namespace hexapose
