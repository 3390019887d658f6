// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/events/event_text.h"

#include "core/base/number_text.h"
#include "ui/console/events/payload_text.h"

#include <QCoreApplication>

#include <new>

namespace hexapose {

namespace {

struct EventWords {
    Q_DECLARE_TR_FUNCTIONS(hexapose::EventText)
};

QString fixed(double value, int decimals) {
    return QString::fromStdString(formatFixed(value, decimals));
}

/// "cause: payload", or the cause alone.
QString withPayload(const QString& cause, const Event& event) {
    const QString payload = payloadText(event.data);
    return payload.isEmpty() ? cause : EventWords::tr("%1: %2").arg(cause, payload);
}

/// What has to come before a command that the machine does not allow now.
QString refusalAdvice(const CommandRefusal& refusal) {
    if (!refusal.allowed) {
        return refusal.command == Command::Resume ? EventWords::tr("There is nothing to resume.")
                                                  : EventWords::tr("Nothing has changed.");
    }
    const CommandSet& allowed = *refusal.allowed;
    const bool needsDrives = refusal.command == Command::Jog;
    if (!allowed.contains(Command::Disable)) {
        return EventWords::tr("Wait until a controller is connected.");
    }
    if (allowed.contains(Command::Clear)) {
        return EventWords::tr("After a stop or a fault press Clear first.");
    }
    if (needsDrives && (allowed.contains(Command::Enable) || allowed.contains(Command::Reference))) {
        return EventWords::tr("Press Enable first; a jog does not switch the drives on.");
    }
    if (refusal.command == Command::Resume) {
        return EventWords::tr("There is nothing to resume.");
    }
    if (allowed.contains(Command::Run)) { // no motion is in the way
        return EventWords::tr("Nothing has changed.");
    }
    return needsDrives ? EventWords::tr("Wait until the motion is over.")
                       : EventWords::tr("Wait until the motion is over, or press Stop.");
}

EventText logContinuedText(const LogContinuation& next) {
    const QString file = payloadText(next);
    const QString advice = EventWords::tr("Leave the log in its place until you disconnect.");
    switch (next.cause) {
    case LogContinuation::Cause::Deleted:
        return {EventWords::tr("The log was deleted; all of it is in %1 now").arg(file), advice, Tone::Warn};
    case LogContinuation::Cause::Moved:
        return {EventWords::tr("The log was moved or replaced; it goes on in %1").arg(file), advice,
                Tone::Warn};
    case LogContinuation::Cause::Full:
        break;
    }
    return {EventWords::tr("The log goes on in %1").arg(file), {}, Tone::Idle};
}

QString moveAdvice(const Event& event) {
    const auto* check = event.get<MotionCheck>();
    if (event.get<MotionInhibit>() || (check && (check->reason == MotionCheck::Reason::StartMoved ||
                                                 check->reason == MotionCheck::Reason::LimitsChanged))) {
        return EventWords::tr("Nothing moved. Try again.");
    }
    return check && check->liesAlongPath()
               ? EventWords::tr("Nothing moved. Go there in smaller steps or in the other mode.")
               : EventWords::tr("Nothing moved. Change the target.");
}

EventText linkText(const Event& event) {
    switch (event.code) {
    case EventCode::Connected:
        return {withPayload(EventWords::tr("Connected"), event), {}, Tone::Good};
    case EventCode::ListenOnly:
        return {EventWords::tr("Listen-only source without checksums"),
                EventWords::tr(
                    "Its values are shown, but it takes no commands, and transmission errors go unnoticed."),
                Tone::Warn};
    case EventCode::LinkLost:
        return {withPayload(EventWords::tr("Connection lost"), event),
                EventWords::tr("Check the cable and the port; the console keeps trying."), Tone::Bad};
    case EventCode::DataStale:
        return {EventWords::tr("No valid measurement for %1 ms").arg(fixed(event.value(), 0)),
                EventWords::tr("The values shown are old. Check the controller and the line."), Tone::Bad};
    case EventCode::DataFresh:
        return {EventWords::tr("Receiving measurements"), {}, Tone::Good};
    case EventCode::ClockWentBack:
        return {EventWords::tr("The controller's clock went back"),
                EventWords::tr("It was probably restarted. Reference it again if it asks for it."),
                Tone::Warn};
    case EventCode::NoAnswer:
        return {withPayload(EventWords::tr("The controller did not answer"), event),
                EventWords::tr("Try again; if it stays silent, check the controller and the line."),
                Tone::Warn};
    default:
        return {};
    }
}

EventText stopText(const Event& event) {
    const QString clear = EventWords::tr("Find the cause, press Clear, then Run.");
    switch (event.code) {
    case EventCode::StopRequested:
        return {withPayload(EventWords::tr("Stop"), event),
                EventWords::tr("Press Clear before the next Run."), Tone::Warn};
    case EventCode::StoppedByController:
        return {withPayload(EventWords::tr("The controller stopped the move"), event), clear, Tone::Bad};
    case EventCode::StoppedOnStaleData:
        return {EventWords::tr("Stopped: no measurements received"), clear, Tone::Bad};
    case EventCode::StoppedOnSolver:
        return {withPayload(EventWords::tr("Stopped: the lengths gave no usable pose"), event), clear,
                Tone::Bad};
    case EventCode::StoppedOnRefusal:
        return {withPayload(EventWords::tr("Stopped: the controller refused a set-point"), event), clear,
                Tone::Bad};
    case EventCode::StoppedOnFollowingError:
        return {withPayload(EventWords::tr("Stopped: a leg does not follow"), event), clear, Tone::Bad};
    case EventCode::StoppedOnNoEcho:
        return {EventWords::tr("Stopped: the controller accepted no set-point for %1 ms")
                    .arg(fixed(event.value(), 0)),
                clear, Tone::Bad};
    case EventCode::StoppedOnLimits:
        return {withPayload(EventWords::tr("Stopped at a limit"), event), clear, Tone::Bad};
    case EventCode::StoppedOnNewIdentity:
        return {
            withPayload(EventWords::tr("Stopped: the controller gave another name or other limits"), event),
            clear, Tone::Bad};
    case EventCode::StoppedAfterLoss:
        return {EventWords::tr("Connection restored after a loss during a move: a stop was sent"), clear,
                Tone::Bad};
    case EventCode::DisableUnconfirmed:
        return {EventWords::tr("The controller did not confirm that the drives are off"),
                EventWords::tr("Check the machine; switch its drives off there."), Tone::Bad};
    case EventCode::LoopFailed:
        return {EventWords::tr("The control loop ended: %1").arg(loopFailureText(event)),
                EventWords::tr("Disconnect and connect again; report the error with its log."), Tone::Bad};
    case EventCode::ControllerFault:
        return {withPayload(EventWords::tr("Controller fault"), event),
                EventWords::tr("Remove the cause at the machine, then press Clear."), Tone::Bad};
    default:
        return {};
    }
}

EventText refusalText(const Event& event) {
    switch (event.code) {
    case EventCode::MoveRefused:
        return {withPayload(EventWords::tr("The move was refused"), event), moveAdvice(event), Tone::Warn};
    case EventCode::PreparationFailed:
        return {withPayload(EventWords::tr("The move did not start: referencing or enabling failed"), event),
                EventWords::tr("Press Reference or Enable and see what the controller answers."), Tone::Warn};
    case EventCode::ControllerRefused:
        return {withPayload(EventWords::tr("The controller refused"), event),
                EventWords::tr("See the controller's manual for the code."), Tone::Warn};
    case EventCode::CommandRefused:
        return {withPayload(EventWords::tr("The command cannot be carried out in this state"), event),
                event.get<CommandRefusal>() ? refusalAdvice(*event.get<CommandRefusal>()) : QString(),
                Tone::Warn};
    case EventCode::JogLimited:
        return {withPayload(EventWords::tr("The jog stopped before a limit"), event),
                EventWords::tr("Jog the other way, or along another axis."), Tone::Warn};
    case EventCode::NotSettled:
        return {EventWords::tr("The legs had not settled after %1 s").arg(fixed(event.value(), 1)),
                EventWords::tr("Look at the leg errors: load, friction or a drive's gain may be the cause."),
                Tone::Warn};
    case EventCode::LogFailed:
        return {withPayload(EventWords::tr("The log cannot be written"), event),
                EventWords::tr("Free space on the disk, then connect again."), Tone::Bad};
    case EventCode::LogSpaceLow:
        return {withPayload(EventWords::tr("Little space is left for the log"), event),
                EventWords::tr("Free space on the disk."), Tone::Warn};
    case EventCode::LogContinued:
        if (const auto* next = event.get<LogContinuation>()) {
            return logContinuedText(*next);
        }
        return {};
    default:
        return {};
    }
}

EventText progressText(const Event& event) {
    switch (event.code) {
    case EventCode::Referencing:
        return {EventWords::tr("Referencing the legs"), {}, Tone::Idle};
    case EventCode::Referenced:
        return {EventWords::tr("The legs are referenced"), {}, Tone::Good};
    case EventCode::Enabled:
        return {EventWords::tr("Enabled"), {}, Tone::Good};
    case EventCode::Disabled:
        return {EventWords::tr("Disabled"), {}, Tone::Idle};
    case EventCode::MoveStarted:
        return {
            EventWords::tr("Move started: %1 s at full speed").arg(fixed(event.value(), 1)), {}, Tone::Idle};
    case EventCode::JogStarted:
        return {EventWords::tr("Jog started"), {}, Tone::Idle};
    case EventCode::Settled:
        return {EventWords::tr("Settled after %1 s").arg(fixed(event.value(), 1)), {}, Tone::Good};
    case EventCode::Cleared:
        return {EventWords::tr("Cleared"), EventWords::tr("Press Run when it is safe to move."), Tone::Idle};
    case EventCode::SolverChanged:
        return {EventWords::tr("The solver is now %1").arg(payloadText(event.data)), {}, Tone::Idle};
    case EventCode::ReportSample:
        return {EventWords::tr("Sample %1 of the report taken").arg(fixed(event.value(), 0)), {}, Tone::Idle};
    default:
        return {};
    }
}

} // namespace

QString loopFailureText(const Event& event) {
    const auto* error = event.get<DeviceText>();
    const std::string text = error != nullptr ? error->text : std::string();
    return text == std::bad_alloc().what()
               ? EventWords::tr("out of memory")
               : EventWords::tr("internal error \"%1\"").arg(QString::fromStdString(text));
}

EventText eventText(const Event& event) {
    for (const auto& group : {linkText, stopText, refusalText, progressText}) {
        if (EventText text = group(event); !text.cause.isEmpty()) {
            return text;
        }
    }
    return {payloadText(event.data), {}, Tone::Idle};
}

} // namespace hexapose
