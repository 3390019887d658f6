// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/events/payload_text.h"

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "ui/common/status_text.h"
#include "ui/console/events/motion_check_text.h"

#include <QCoreApplication>

namespace hexapose {

namespace {

struct PayloadText {
    Q_DECLARE_TR_FUNCTIONS(hexapose::PayloadText)
};

QString foreign(const std::string& text) {
    return QString::fromStdString(text);
}

QString millimetres(double metres, int decimals) {
    return QString::fromStdString(formatFixed(mmFromMetres(metres), decimals));
}

QString sweepFaultText(SweepFault fault) {
    switch (fault) {
    case SweepFault::NoSuchAxis:
        return PayloadText::tr("the sweep names no axis");
    case SweepFault::Amplitude:
        return PayloadText::tr("the amplitude of the sweep is not above zero");
    case SweepFault::Frequency:
        return PayloadText::tr("a frequency of the sweep is below zero");
    case SweepFault::Duration:
        break;
    }
    return PayloadText::tr("the duration of the sweep is not above zero");
}

QString reasonText(const DeviceRefusal& refusal) {
    switch (refusal.reason) {
    case RefusalReason::NotConnected:
        return PayloadText::tr("no controller is connected");
    case RefusalReason::StopUnconfirmed:
        return PayloadText::tr("the controller has not confirmed the stop yet");
    case RefusalReason::LengthNotPositive:
        return PayloadText::tr("a length is not a positive number");
    case RefusalReason::ProtocolVersion:
        return PayloadText::tr("it speaks protocol version %1, not 1").arg(refusal.number);
    case RefusalReason::LegCount:
        return PayloadText::tr("it has %1 legs, not 6").arg(refusal.number);
    case RefusalReason::IdentityFields:
        return PayloadText::tr("a field of its identity cannot be read, or is out of range");
    case RefusalReason::State:
    case RefusalReason::Range:
    case RefusalReason::Format:
    case RefusalReason::Other:
        break;
    }
    return foreign(refusal.text);
}

QString text(std::monostate) {
    return {};
}
QString text(double) {
    return {};
}
QString text(const DeviceText& data) {
    return foreign(data.text);
}

QString text(const PortFailure& failure) {
    const QString reason = [&] {
        switch (failure.kind) {
        case PortFailure::Kind::NotFound:
            return PayloadText::tr("there is no such port");
        case PortFailure::Kind::NotAPort:
            return PayloadText::tr("this is not a serial port");
        case PortFailure::Kind::NoPermission:
            return PayloadText::tr(
                       "no permission; add yourself to the group of serial ports (%1), then log in again")
                .arg(QStringLiteral("sudo usermod -aG dialout $USER"));
        case PortFailure::Kind::Busy:
            return PayloadText::tr("another program has the port open");
        case PortFailure::Kind::NotOpened:
            return PayloadText::tr("the port cannot be opened (%1)").arg(foreign(failure.system));
        case PortFailure::Kind::Gone:
            return PayloadText::tr("the port is gone");
        case PortFailure::Kind::NotTaking:
            return PayloadText::tr("the port accepts no more bytes");
        case PortFailure::Kind::Closed:
            return PayloadText::tr("the port is closed");
        case PortFailure::Kind::Other:
            break;
        }
        return foreign(failure.system);
    }();
    return failure.path.empty() ? reason : PayloadText::tr("%1: %2").arg(foreign(failure.path), reason);
}

QString text(const MotionCheck& check) {
    return motionCheckText(check);
}

QString text(const MotionInhibit& inhibit) {
    return inhibit.solver ? solveStatusText(*inhibit.solver)
                          : PayloadText::tr("the last measurement is too old");
}

QString text(SweepFault fault) {
    return sweepFaultText(fault);
}

QString text(Command command) {
    return command == Command::Disable ? PayloadText::tr("disabling was commanded") : QString();
}

QString text(ControllerState state) {
    return controllerStateText(state);
}

QString text(SolveStatus status) {
    return solveStatusText(status);
}

QString text(const DeviceRefusal& refusal) {
    const QString request = requestText(refusal.request);
    return request.isEmpty() ? reasonText(refusal)
                             : PayloadText::tr("%1: %2").arg(request, reasonText(refusal));
}

QString text(DeviceRequest request) {
    return requestText(request);
}

QString text(const CommandRefusal& refusal) {
    return stateText(refusal.state);
}

QString text(const FollowingError& error) {
    const QString leg = QString::number(error.leg);
    switch (error.cause) {
    case FollowingError::Cause::SetPoint:
        return PayloadText::tr("leg %1 is %2 mm from its set-point, more than %3 mm")
            .arg(leg, millimetres(error.gap, 2), millimetres(error.limit, 1));
    case FollowingError::Cause::Path:
        return PayloadText::tr("leg %1 is %2 mm off the path, more than %3 mm")
            .arg(leg, millimetres(error.gap, 2), millimetres(error.limit, 1));
    case FollowingError::Cause::Stalled:
        break;
    }
    return PayloadText::tr("leg %1 is %2 mm off the path, and the motion makes no progress")
        .arg(leg, millimetres(error.gap, 2));
}

QString text(const PreparationFailure& failure) {
    if (failure.refusal)
        return text(*failure.refusal);
    return failure.answered ? PayloadText::tr("%1 did not finish in time").arg(requestText(failure.request))
                            : PayloadText::tr("%1: not answered").arg(requestText(failure.request));
}

QString text(const ControllerIdentity& identity) {
    if (!identity.minLength || !identity.maxLength)
        return foreign(identity.name);
    const QString limits = PayloadText::tr("%1 to %2 mm")
                               .arg(QString::fromStdString(formatNumber(mmFromMetres(*identity.minLength))),
                                    QString::fromStdString(formatNumber(mmFromMetres(*identity.maxLength))));
    return identity.name.empty() ? limits : PayloadText::tr("%1, %2").arg(foreign(identity.name), limits);
}

QString text(const SolverChoice& choice) {
    return solverTitle(choice.name);
}

QString text(const LogFailure& failure) {
    return failure.system.empty() ? PayloadText::tr("%1 rows were lost").arg(failure.rowsLost)
                                  : foreign(failure.system);
}

QString text(const LogSpace& space) {
    constexpr double kBytesInGigabyte = 1e9;
    const QString gigabytes =
        QString::fromStdString(formatFixed(static_cast<double>(space.freeBytes) / kBytesInGigabyte, 2));
    return space.secondsLeft
               ? PayloadText::tr("%1 GB, enough for %2 min")
                     .arg(gigabytes, QString::fromStdString(formatFixed(*space.secondsLeft / 60.0, 0)))
               : PayloadText::tr("%1 GB").arg(gigabytes);
}

QString text(const LogContinuation& continuation) {
    return foreign(continuation.file);
}

} // namespace

QString payloadText(const EventData& data) {
    return std::visit([](const auto& value) { return text(value); }, data);
}

QString requestText(DeviceRequest request) {
    switch (request) {
    case DeviceRequest::Reference:
        return PayloadText::tr("Reference");
    case DeviceRequest::Enable:
        return PayloadText::tr("Enable");
    case DeviceRequest::Disable:
        return PayloadText::tr("Disable");
    case DeviceRequest::Stop:
        return PayloadText::tr("Stop");
    case DeviceRequest::Clear:
        return PayloadText::tr("Clear");
    case DeviceRequest::SetPoint:
        return PayloadText::tr("Set-point");
    case DeviceRequest::Period:
        return PayloadText::tr("Feedback period");
    case DeviceRequest::Hello:
    case DeviceRequest::Identity:
        return PayloadText::tr("Identification");
    case DeviceRequest::None:
    case DeviceRequest::Other:
        break;
    }
    return {};
}

QString controllerStateText(ControllerState state) {
    switch (state) {
    case ControllerState::Unreferenced:
        return stateText(RunState::Unreferenced);
    case ControllerState::Disabled:
        return stateText(RunState::Disabled);
    case ControllerState::Enabled:
        return stateText(RunState::Enabled);
    case ControllerState::Stopped:
        return stateText(RunState::Stopped);
    case ControllerState::Fault:
        return stateText(RunState::Fault);
    case ControllerState::Unknown:
        break;
    }
    return PayloadText::tr("Unknown state");
}

} // namespace hexapose
