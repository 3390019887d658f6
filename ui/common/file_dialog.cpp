// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/file_dialog.h"

#include <utility>

namespace hexapose {

void askForFile(QWidget& owner, const FileQuestion& question, std::function<void(const QString&)> chosen) {
    for (auto* open : owner.findChildren<QFileDialog*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (open->windowTitle() == question.title) {
            open->raise();
            open->activateWindow();
            return;
        }
    }
    auto* dialog = new QFileDialog(&owner, question.title, question.folder, question.filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setAcceptMode(question.accept);
    dialog->setFileMode(question.mode);
    dialog->setDefaultSuffix(question.suffix);
    dialog->setModal(false);
    QObject::connect(dialog, &QFileDialog::fileSelected, &owner, std::move(chosen));
    dialog->show();
}

} // namespace hexapose
