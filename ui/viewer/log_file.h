// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table_loader.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <memory>

namespace hexapose {

/// A log that is open: it is read in the background, and says on the thread of the screen when there is more.
class LogFile final : public QObject {
    Q_OBJECT
public:
    explicit LogFile(const QString& path, QObject* parent = nullptr);
    ~LogFile() override;

    const QString& path() const { return m_path; }
    QString name() const; ///< without the folder
    std::shared_ptr<const Table> table() const { return m_loader->table(); }
    LoadProgress progress() const { return m_loader->progress(); }
    void cancel() { m_loader->cancel(); }

signals:
    /// More was read, or the reading has ended.
    void changed();

private:
    QString m_path;
    std::atomic<bool> m_isTold{false}; ///< changed() is on its way
    std::unique_ptr<TableLoader> m_loader;
};

} // namespace hexapose
