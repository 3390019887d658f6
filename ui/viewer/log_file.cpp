// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/log_file.h"

#include <QFile>
#include <QFileInfo>
#include <QMetaObject>

namespace hexapose {

LogFile::LogFile(const QString& path, QObject* parent) : QObject(parent), m_path(path) {
    TableLoader::Options options;
    options.onProgress = [this] {
        if (m_isTold.exchange(true))
            return;
        QMetaObject::invokeMethod(
            this,
            [this] {
                m_isTold = false;
                emit changed();
            },
            Qt::QueuedConnection);
    };
    m_loader = std::make_unique<TableLoader>(QFile::encodeName(path).toStdString(), options);
}

LogFile::~LogFile() {
    m_loader.reset(); // no thread of it calls this object any more
}

QString LogFile::name() const {
    return QFileInfo(m_path).fileName();
}

} // namespace hexapose

#include "moc_log_file.cpp"
