// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QSocketNotifier;

namespace hexapose {

/// SIGINT, SIGTERM and SIGHUP as an event of the event loop, so that the platform is stopped and disabled in
/// the ordinary way. Made before any thread is started: each inherits that these signals wait.
class EndSignals final : public QObject {
    Q_OBJECT
public:
    EndSignals();
    ~EndSignals() override;
    /// From now on received() is emitted. Needs the application.
    void watch();

signals:
    void received(int number);

private:
    void take();

    int m_descriptor = -1;
    QSocketNotifier* m_notifier = nullptr;
};

} // namespace hexapose
