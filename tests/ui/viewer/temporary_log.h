// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table_loader.h"

#include <QMimeData>
#include <QTemporaryDir>
#include <QWidget>

#include <functional>
#include <string>

namespace hexapose::testing {

/// A log in a folder of its own.
class TemporaryLog {
public:
    explicit TemporaryLog(const std::string& text, const std::string& name = "run.csv");
    const std::string& file() const { return m_file; }
    QString path() const { return QString::fromStdString(m_file); }
    QString folder() const { return m_folder.path(); }
    std::shared_ptr<const Table> table() const { return loadTable(m_file); }

private:
    QTemporaryDir m_folder;
    std::string m_file;
};

/// A file's bytes.
std::string bytesOf(const std::string& file);

/// "time_s,a,state,event", a row each 10 ms: a is a sine with a spike of 100 at row 5000, moving from 10 s to
/// 20 s.
std::string logText(int rows);

/// As from the window system.
void drop(QWidget& widget, const QMimeData& data);

/// Lets the event loop run until something is so; false when it does not come to be.
bool waitUntil(const std::function<bool()>& isSo);

} // namespace hexapose::testing
