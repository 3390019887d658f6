// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QObject>

namespace hexapose {

/// The keys that are down. Some desktops repeat a held key as a release and a press that nothing marks, at
/// once or a little apart: a release counts when no press has followed by then. Nobody presses a key again as
/// fast.
class DownKeys final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    bool contains(int key) const { return m_keys.contains(key); }
    bool isEmpty() const { return m_keys.isEmpty(); }
    /// Pressed, or repeated while it is down.
    void press(int key) { m_keys[key] = kDown; }
    void release(int key);
    void clear() { m_keys.clear(); }

signals:
    void up(int key);

private:
    static constexpr int kDown = 0;
    QHash<int, int> m_keys; ///< kDown, or the number of the release that may be one
    int m_releases = 0;
};

} // namespace hexapose
