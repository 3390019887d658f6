// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDialog>

#include <functional>

namespace hexapose {

/// Which file or folder is asked for.
struct FileQuestion {
    QString title;
    QString filter = {};
    QString folder = {};
    QFileDialog::FileMode mode = QFileDialog::ExistingFile;
    QFileDialog::AcceptMode accept = QFileDialog::AcceptOpen;
    QString suffix = {}; ///< of a name that is typed without one; that of the filter when one is chosen
};

/// Asks in a dialog beside the window and not before it: Stop stays within reach. It is Qt's own dialog, for
/// the desktop's would keep Esc for itself. While it is open, asking again raises it.
void askForFile(QWidget& owner, const FileQuestion& question, std::function<void(const QString&)> chosen);
/// The same for one or several that there are.
void askForFiles(QWidget& owner, FileQuestion question, std::function<void(const QStringList&)> chosen);

} // namespace hexapose
