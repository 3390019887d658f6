// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/console/window/operator_window.h"

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <array>
#include <filesystem>

namespace hexapose {

/// The operator's main job without an operator: types a target into the window's own fields, presses Run,
/// waits until it has settled, runs a short report, exports it and keeps a picture of the window.
class HeadlessJob final : public QObject {
    Q_OBJECT
public:
    /// output: empty for beside the log.
    HeadlessJob(OperatorWindow& window, const std::filesystem::path& output, QObject* parent = nullptr);
    void start();
    /// Stops, disables and ends with the status of a failure.
    void interrupt() { fail(QStringLiteral("interrupted")); }

signals:
    /// exitStatus: 0 or 1.
    void finished(int exitStatus);

private:
    enum class Step { Connecting, Starting, Moving, Reporting, Exporting, Ended };
    void advance();
    void nextStep();
    void typeTarget();
    void type(const std::array<double, 6>& shown);
    void startReport();
    void savePicture();
    void watch(const Event& event);
    void fail(const QString& reason);
    void end(int exitStatus);
    void press(const char* button);

    OperatorWindow& m_window;
    std::filesystem::path m_output;
    Step m_step = Step::Connecting;
    QTimer m_timer;
    QElapsedTimer m_sinceStep;
    QStringList m_files;
    QString m_logFile;
};

} // namespace hexapose
