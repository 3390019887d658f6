// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/operator_command.h"
#include "core/record/run_state.h"
#include "ui/session/session.h"

#include <QFrame>

#include <functional>

class QComboBox;
class QLabel;
class QPushButton;

namespace hexapose {

/// Lists the serial ports that the system knows at the moment.
using PortList = std::function<QStringList()>;

/// Where to connect, and what is done with the machine before it moves: Reference, Enable or Disable, Clear.
class ConnectionPanel final : public QWidget {
    Q_OBJECT
public:
    explicit ConnectionPanel(PortList ports, QWidget* parent = nullptr);
    void setChoice(const ConnectionChoice& choice);
    /// Nothing when the baud rate is no number or no port is named.
    std::optional<ConnectionChoice> choice() const;
    /// available: there is something to connect with (the model is ready).
    void setAvailable(bool available);
    void setOpen(bool open);
    void showState(RunState state);

signals:
    void connectRequested(const hexapose::ConnectionChoice& choice);
    void disconnectRequested();
    void commandRequested(const hexapose::OperatorCommand& command);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void refreshPorts();
    void updateButtons();
    void retranslate();
    bool isVirtual() const;

    PortList m_ports;
    bool m_available = false;
    bool m_open = false;
    RunState m_state = RunState::Disconnected;
    QLabel* m_portLabel;
    QComboBox* m_port;
    QLabel* m_baudLabel;
    QComboBox* m_baud;
    QPushButton* m_connect;
    QPushButton* m_reference;
    QPushButton* m_enable;
    QPushButton* m_clear;
};

} // namespace hexapose
