// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/machine/command.h"
#include "core/record/command_set.h"
#include "core/record/snapshot.h"
#include "core/session/connection.h"

#include <QFrame>

#include <functional>
#include <string_view>

class QComboBox;
class QLabel;
class QPushButton;

namespace hexapose {

class NumberField;

/// Lists the serial ports that the system knows at the moment.
using PortList = std::function<QStringList()>;

/// Where to connect, which solver makes poses of what comes from there, and what is done with the machine
/// before it moves: Reference, Enable or Disable, Clear.
class ConnectionPanel final : public QWidget {
    Q_OBJECT
public:
    explicit ConnectionPanel(PortList ports, QWidget* parent = nullptr);
    void setChoice(const ConnectionSpec& choice);
    /// Nothing when the baud rate is refused or no port is named.
    std::optional<ConnectionSpec> choice() const;
    /// available: there is something to connect with (the model is ready).
    void setAvailable(bool available);
    void setOpen(bool open);
    /// Shows it as chosen; a word of kSolverChoices, else nothing is.
    void setSolver(std::string_view word);
    /// While a solver is made ready no other can be chosen.
    void setSolverPending(bool pending);
    void showSnapshot(const Snapshot& snapshot);

signals:
    void connectRequested(const hexapose::ConnectionSpec& choice);
    void disconnectRequested();
    void commandRequested(const hexapose::OperatorCommand& command);
    void solverChosen(const QString& word);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void refreshPorts();
    void updateButtons();
    void updateSolver();
    void retranslate();
    bool isVirtual() const;
    QString connectReason() const;
    void showConnectReason();

    PortList m_ports;
    bool m_available = false;
    bool m_open = false;
    bool m_solverPending = false;
    bool m_solverHadFocus = false;
    bool m_moving = false;
    bool m_drivesOn = false;
    CommandSet m_allowed; ///< what the loop would accept
    QLabel* m_portLabel;
    QComboBox* m_port;
    QLabel* m_baudLabel;
    QComboBox* m_baud;
    NumberField* m_baudField; ///< its editor
    QLabel* m_baudRefusal;
    QLabel* m_solverLabel;
    QComboBox* m_solver;
    QPushButton* m_connect;
    QPushButton* m_reference;
    QPushButton* m_enable;
    QPushButton* m_clear;
};

} // namespace hexapose
