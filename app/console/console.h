// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console_options.h"
#include "app/console/model_job.h"
#include "core/kinematics/platform_model.h"
#include "ui/common/language.h"
#include "ui/console/window/operator_window.h"

#include <QObject>

#include <memory>
#include <string>

class QApplication;
class QSettings;

namespace hexapose {

class NamedPoses;

/// Puts the console together: look, language, window, solver, session.
class Console final : public QObject {
    Q_OBJECT
public:
    Console(QApplication& application, const ConsoleOptions& options);
    ~Console() override;
    void start();
    OperatorWindow& window() { return *m_window; }

signals:
    /// A solver is ready and the session is there; open when an option named a connection and its log could
    /// be created.
    void sessionReady();

private:
    void chooseLook(QSettings& settings);
    void loadPoses(NamedPoses& named, QSettings& settings);
    void makeSolver(const std::string& method);
    void useSolver(const ReadySolver& solver);
    void openSession(const ReadySolver& solver);
    void fallBackToNewton(const QString& reason);

    QApplication& m_application;
    ConsoleOptions m_options;
    SharedModel m_platform; ///< of window, session and solver
    LanguageSwitch m_language;
    ThemeKind m_theme = ThemeKind::Light;
    std::unique_ptr<OperatorWindow> m_window;
    std::unique_ptr<ModelJob> m_model; ///< of the solver in use, or of the one that is being made ready
};

} // namespace hexapose
