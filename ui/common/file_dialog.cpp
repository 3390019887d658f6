// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/file_dialog.h"

#include <QRegularExpression>

#include <utility>

namespace hexapose {

namespace {

/// "svg" of "SVG drawing (*.svg)"; empty where there are several.
QString suffixOf(const QString& filter) {
    static const QRegularExpression one(QStringLiteral(R"(\(\*\.(\w+)\)$)"));
    return one.match(filter).captured(1);
}

/// Null where it is open already.
QFileDialog* makeDialog(QWidget& owner, const FileQuestion& question) {
    for (auto* open : owner.findChildren<QFileDialog*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (open->windowTitle() == question.title) {
            open->raise();
            open->activateWindow();
            return nullptr;
        }
    }
    auto* dialog = new QFileDialog(&owner, question.title, question.folder, question.filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setAcceptMode(question.accept);
    dialog->setFileMode(question.mode);
    dialog->setDefaultSuffix(question.suffix);
    dialog->setModal(false);
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        if (const QString suffix = suffixOf(filter); !suffix.isEmpty())
            dialog->setDefaultSuffix(suffix);
    });
    return dialog;
}

} // namespace

void askForFile(QWidget& owner, const FileQuestion& question, std::function<void(const QString&)> chosen) {
    if (QFileDialog* dialog = makeDialog(owner, question)) {
        QObject::connect(dialog, &QFileDialog::fileSelected, &owner, std::move(chosen));
        dialog->show();
    }
}

void askForFiles(QWidget& owner, FileQuestion question, std::function<void(const QStringList&)> chosen) {
    question.mode = QFileDialog::ExistingFiles;
    if (QFileDialog* dialog = makeDialog(owner, question)) {
        QObject::connect(dialog, &QFileDialog::filesSelected, &owner, std::move(chosen));
        dialog->show();
    }
}

} // namespace hexapose
