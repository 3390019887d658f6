// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/status/connection_panel.h"

#include "ui/common/card.h"
#include "ui/common/labelled.h"
#include "ui/common/number_field.h"
#include "ui/common/solver_choices.h"
#include "ui/common/status_text.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <utility>

namespace hexapose {

namespace {

constexpr int kBaudRates[] = {9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600};
constexpr int kUsualBaud = 115200;
constexpr NumberBounds kBaudBounds{1.0, 99999999.0, true};

/// Looks for ports each time it is opened, because adapters come and go.
class PortBox final : public QComboBox {
public:
    PortBox(std::function<void()> refresh, QWidget* parent)
        : QComboBox(parent), m_refresh(std::move(refresh)) {}
    void showPopup() override {
        m_refresh();
        QComboBox::showPopup();
    }

private:
    std::function<void()> m_refresh;
};

/// Steps through the usual rates, also from one that is typed and none of them.
class BaudBox final : public QComboBox {
public:
    using QComboBox::QComboBox;

protected:
    void keyPressEvent(QKeyEvent* event) override {
        switch (event->key()) {
        case Qt::Key_Up:
        case Qt::Key_PageUp:
            return step(-1);
        case Qt::Key_Down:
        case Qt::Key_PageDown:
            return step(1);
        default:
            QComboBox::keyPressEvent(event);
        }
    }

private:
    /// As in the list, where the rates grow downwards.
    void step(int direction) {
        const int typed = currentText().toInt();
        int next = direction > 0 ? 0 : count() - 1;
        while (next >= 0 && next < count() && (itemText(next).toInt() - typed) * direction <= 0) {
            next += direction;
        }
        if (next >= 0 && next < count()) {
            setCurrentIndex(next);
            setEditText(itemText(next)); // also where that was the current one before something was typed
        }
    }
};

} // namespace

ConnectionPanel::ConnectionPanel(PortList ports, QWidget* parent)
    : QWidget(parent), m_ports(std::move(ports)) {
    build();
    retranslate();
    updateButtons();
}

void ConnectionPanel::build() {
    m_portLabel = makeCaption(this);
    m_port = new PortBox([this] { refreshPorts(); }, this);
    m_port->setEditable(true);
    m_port->setCompleter(nullptr); // a typed path is taken as it is typed
    m_port->setInsertPolicy(QComboBox::NoInsert);
    m_port->setMinimumWidth(170);
    m_port->addItem(QString());
    m_baudLabel = makeCaption(this);
    m_baud = new BaudBox(this);
    m_baudField = new NumberField(kBaudBounds);
    m_baud->setLineEdit(m_baudField); // which makes it editable
    m_baud->setInsertPolicy(QComboBox::NoInsert);
    m_baud->setCompleter(nullptr); // a rate is taken as it is typed
    m_baudRefusal = makeMutedLabel(this);
    setTone(*m_baudRefusal, Tone::Bad);
    m_baudRefusal->hide();
    for (const int rate : kBaudRates) {
        m_baud->addItem(QString::number(rate));
    }
    m_baud->setCurrentText(QString::number(SerialConnection::kUsualBaud));
    m_solverLabel = makeCaption(this);
    m_solver = new QComboBox(this);
    for (const std::string_view word : kSolverChoices) {
        m_solver->addItem(solverTitle(word),
                          QString::fromLatin1(word.data(), static_cast<qsizetype>(word.size())));
    }
    m_connect = new QPushButton(this);
    m_reference = new QPushButton(this);
    m_enable = new QPushButton(this);
    m_clear = new QPushButton(this);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_portLabel, m_port, m_baudLabel, m_baud,
                                                           m_baudRefusal, m_connect}) {
        row->addWidget(widget);
    }
    row->addSpacing(14);
    row->addWidget(m_solverLabel);
    row->addWidget(m_solver);
    row->addSpacing(14);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_reference, m_enable, m_clear}) {
        row->addWidget(widget);
    }

    connect(m_port, &QComboBox::currentTextChanged, this, &ConnectionPanel::updateButtons);
    connect(m_baud, &QComboBox::currentTextChanged, this, &ConnectionPanel::updateButtons);
    connect(m_solver, &QComboBox::currentIndexChanged, this, [this] {
        if (const QString word = m_solver->currentData().toString(); !word.isEmpty()) {
            emit solverChosen(word);
        }
    });
    connect(m_connect, &QPushButton::clicked, this, [this] {
        if (m_open) {
            emit disconnectRequested();
        } else if (const auto where = choice()) {
            emit connectRequested(*where);
        }
    });
    connect(m_reference, &QPushButton::clicked, this, [this] { emit commandRequested(ReferenceCommand{}); });
    connect(m_enable, &QPushButton::clicked, this, [this] {
        emit commandRequested(m_drivesOn ? OperatorCommand(DisableCommand{})
                                         : OperatorCommand(EnableCommand{}));
    });
    connect(m_clear, &QPushButton::clicked, this, [this] { emit commandRequested(ClearCommand{}); });
}

void ConnectionPanel::refreshPorts() {
    const QString typed = m_port->currentText();
    const QSignalBlocker quiet(m_port);
    while (m_port->count() > 1) {
        m_port->removeItem(1);
    }
    m_port->addItems(m_ports ? m_ports() : QStringList());
    m_port->setCurrentIndex(m_port->findText(typed));
    m_port->setEditText(typed);
}

bool ConnectionPanel::isVirtual() const {
    return m_port->currentText().trimmed() == m_port->itemText(0);
}

void ConnectionPanel::setChoice(const ConnectionSpec& choice) {
    const auto* serial = std::get_if<SerialConnection>(&choice);
    m_port->setEditText(serial == nullptr ? m_port->itemText(0) : QString::fromStdString(serial->path));
    if (serial != nullptr) {
        m_baud->setEditText(QString::number(serial->baud));
    }
}

std::optional<ConnectionSpec> ConnectionPanel::choice() const {
    if (!connectReason().isEmpty()) {
        return std::nullopt;
    }
    if (isVirtual()) {
        return VirtualConnection{};
    }
    return SerialConnection{m_port->currentText().trimmed().toStdString(),
                            static_cast<int>(m_baudField->value().value_or(kUsualBaud))};
}

/// Why nothing can be connected with what is typed; empty when it can.
QString ConnectionPanel::connectReason() const {
    if (isVirtual()) {
        return {};
    }
    if (m_port->currentText().trimmed().isEmpty()) {
        return tr("Cannot connect: no port is named");
    }
    return m_baudField->isRefused() ? tr("Cannot connect: baud rate: %1").arg(m_baudField->refusal())
                                    : QString();
}

void ConnectionPanel::showConnectReason() {
    const bool refused = !m_open && !isVirtual() && m_baudField->isRefused();
    m_baudRefusal->setText(m_baudField->refusal());
    m_baudRefusal->setVisible(refused);
    const QString tip = m_open ? tr("Stop, disable and close the port") : tr("Open the port; nothing moves");
    const QString reason = m_open ? QString() : connectReason();
    m_connect->setToolTip(reason.isEmpty() ? tip : reason);
    m_connect->setAccessibleDescription(m_connect->toolTip());
}

void ConnectionPanel::setAvailable(bool available) {
    m_available = available;
    updateButtons();
}

void ConnectionPanel::setSolver(std::string_view word) {
    const QSignalBlocker quiet(m_solver);
    m_solver->setCurrentIndex(
        m_solver->findData(QString::fromLatin1(word.data(), static_cast<qsizetype>(word.size()))));
}

void ConnectionPanel::setSolverPending(bool pending) {
    m_solverPending = pending;
    updateSolver();
}

/// In mid-move the loop keeps the solver it has.
void ConnectionPanel::updateSolver() {
    const bool free = !m_moving && !m_solverPending;
    // Qt would hand the focus of a disabled box on to a button, and the next key might press it.
    if (!free && window()->focusWidget() == m_solver) {
        m_solver->clearFocus();
        m_solverHadFocus = true;
    }
    m_solver->setEnabled(free);
    if (free && std::exchange(m_solverHadFocus, false) && window()->focusWidget() == nullptr) {
        m_solver->setFocus();
    }
    const QString why =
        m_moving ? tr("The solver cannot be changed while the platform moves.")
        : m_solverPending
            ? tr("The solver is being prepared.")
            : tr("Method that computes the pose from the leg lengths.\nMPR3-NR, MPR2-NR: regression, "
                 "then Newton\nNewton: iteration alone\nFSI: follows the path of the legs in "
                 "small steps\nChanging it moves nothing.");
    m_solver->setToolTip(why);
    m_solver->setAccessibleDescription(why);
}

void ConnectionPanel::setOpen(bool open) {
    m_open = open;
    m_moving = m_drivesOn = false;
    m_allowed = {};
    retranslate();
    updateButtons();
}

void ConnectionPanel::showSnapshot(const Snapshot& snapshot) {
    const CommandSet& allowed = snapshot.allowed;
    const bool moving = snapshot.state == RunState::Moving || snapshot.state == RunState::Settling;
    // Drives that were on when the link came up are taken over by Enable.
    const bool on = !allowed.contains(Command::Enable) && allowed.contains(Command::Disable) &&
                    (moving || snapshot.state == RunState::Enabled);
    if (allowed == m_allowed && moving == m_moving && on == m_drivesOn) {
        return;
    }
    m_allowed = allowed;
    m_moving = moving;
    m_drivesOn = on;
    retranslate();
    updateButtons();
}

void ConnectionPanel::updateButtons() {
    updateSolver();
    m_port->setEnabled(!m_open);
    m_baud->setEnabled(!m_open && !isVirtual());
    m_connect->setEnabled(m_open || (m_available && choice()));
    showConnectReason();
    m_reference->setEnabled(m_open && m_allowed.contains(Command::Reference));
    m_enable->setEnabled(m_open && m_allowed.contains(m_drivesOn ? Command::Disable : Command::Enable));
    m_clear->setEnabled(m_open && m_allowed.contains(Command::Clear));
}

void ConnectionPanel::retranslate() {
    const bool wasVirtual = m_port->currentText() == m_port->itemText(0);
    m_port->setItemText(0, tr("Virtual platform"));
    if (wasVirtual) {
        m_port->setEditText(m_port->itemText(0));
    }
    m_portLabel->setText(tr("Connection"));
    // On Linux a box gives its value for its name; its editor is where a screen reader finds the name.
    for (QWidget* widget : std::initializer_list<QWidget*>{m_port, m_port->lineEdit()}) {
        widget->setAccessibleName(tr("Connection"));
    }
    m_port->setToolTip(tr("The built-in virtual platform, or a serial port; any path can be typed"));
    m_baudLabel->setText(tr("Baud rate"));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_baud, m_baud->lineEdit()}) {
        widget->setAccessibleName(tr("Baud rate"));
    }
    m_solverLabel->setText(tr("Solver"));
    m_solver->setAccessibleName(tr("Solver"));
    updateSolver();
    label(*m_connect, m_open ? tr("Disconnect") : tr("Connect"));
    showConnectReason();
    label(*m_reference, tr("Reference"), tr("Find the reference of the legs"));
    label(*m_enable, m_drivesOn ? tr("Disable") : tr("Enable"),
          m_drivesOn ? tr("Switch the drives off") : tr("Switch the drives on"));
    label(*m_clear, tr("Clear"), tr("Acknowledge the stop or fault (no motion)"));
}

void ConnectionPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_connection_panel.cpp"
