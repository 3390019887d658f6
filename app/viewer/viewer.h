// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewer/viewer_options.h"
#include "ui/common/language.h"
#include "ui/viewer/viewer_window.h"

#include <QObject>

#include <memory>

class QApplication;
class QSettings;

namespace hexapose {

class ViewerMenu;

/// The program: its window, its look, and what it remembers.
class Viewer final : public QObject {
    Q_OBJECT
public:
    Viewer(QApplication& application, const ViewerOptions& options);
    ~Viewer() override;
    /// Throws InputError for a layout that cannot be read.
    void start();

private:
    void chooseLook(QSettings& settings);
    void remember(const QString& log);

    QApplication& m_application;
    ViewerOptions m_options;
    LanguageSwitch m_language;
    ThemeKind m_theme = ThemeKind::Light;
    std::unique_ptr<ViewerWindow> m_window;
    ViewerMenu* m_menu = nullptr;
};

} // namespace hexapose
