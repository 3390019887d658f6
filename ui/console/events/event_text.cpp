// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/events/event_text.h"

#include "core/base/number_text.h"
#include "core/kinematics/forward_solver.h"
#include "core/record/run_state.h"
#include "ui/common/status_text.h"
#include "ui/console/events/motion_check_text.h"

#include <QCoreApplication>

#include <cstdio>

namespace hexapose {

namespace {

struct EventWords {
    Q_DECLARE_TR_FUNCTIONS(hexapose::EventText)
};

QString fixed(double value, int decimals) {
    return QString::fromStdString(formatFixed(value, decimals));
}
QString detailOf(const Event& event) {
    return QString::fromStdString(event.detail);
}

/// "cause: detail", or the cause alone.
QString withDetail(const QString& cause, const QString& detail) {
    return detail.isEmpty() ? cause : EventWords::tr("%1: %2").arg(cause, detail);
}

QString solverDetail(const Event& event) {
    const auto status = solveStatusFromWord(event.detail);
    return status ? solveStatusText(*status) : detailOf(event);
}

QString moveRefusal(const Event& event) {
    if (event.detail == "stale data") {
        return EventWords::tr("the last measurement is too old");
    }
    const auto status = solveStatusFromWord(event.detail);
    return status && *status != SolveStatus::InvalidInput ? solveStatusText(*status)
                                                          : motionCheckTextFromWords(detailOf(event));
}

/// "run in stopped": the state in the language of the screen.
QString refusalDetail(const Event& event) {
    const std::size_t in = event.detail.rfind(" in ");
    const auto state = in == std::string::npos ? std::nullopt : runStateFromWord(event.detail.substr(in + 4));
    return state ? stateText(*state) : detailOf(event);
}

/// What has to come before a command that the present state does not allow.
QString refusalAdvice(const Event& event) {
    const bool down = event.detail.ends_with(" in stopped") || event.detail.ends_with(" in fault");
    const bool moving = event.detail.ends_with(" in moving") || event.detail.ends_with(" in settling");
    if (event.detail.starts_with("jog") && !down) {
        return moving ? EventWords::tr("Wait until the motion is over.")
                      : EventWords::tr("Press Enable first; a jog does not put the drives on.");
    }
    return moving ? EventWords::tr("Wait until the motion is over, or press Stop.")
                  : EventWords::tr("After a stop or a fault press Clear first.");
}

QString controllerStateDetail(const Event& event) {
    if (event.detail == "S") {
        return stateText(RunState::Stopped);
    }
    if (event.detail == "F") {
        return stateText(RunState::Fault);
    }
    if (event.detail == "U") {
        return stateText(RunState::Unreferenced);
    }
    return event.detail == "D" ? stateText(RunState::Disabled) : detailOf(event);
}

EventText linkText(const Event& event) {
    switch (event.code) {
    case EventCode::Connected:
        return {withDetail(EventWords::tr("Connected"), detailOf(event)), {}, Tone::Good};
    case EventCode::ListenOnly:
        return {EventWords::tr("An unprotected sender of lengths"),
                EventWords::tr(
                    "Its values are shown, but it takes no commands and errors on the line stay unseen."),
                Tone::Warn};
    case EventCode::LinkLost:
        return {withDetail(EventWords::tr("The link is lost"), detailOf(event)),
                EventWords::tr("Check the cable and the port; the console keeps trying."), Tone::Bad};
    case EventCode::DataStale:
        return {EventWords::tr("No valid measurement for %1 ms").arg(fixed(event.value, 0)),
                EventWords::tr("The values shown are old. Check the controller and the line."), Tone::Bad};
    case EventCode::DataFresh:
        return {EventWords::tr("Measurements arrive"), {}, Tone::Good};
    case EventCode::ClockWentBack:
        return {EventWords::tr("The controller's clock went back"),
                EventWords::tr("It was probably restarted. Reference it again if it asks for it."),
                Tone::Warn};
    case EventCode::NoAnswer:
        return {withDetail(EventWords::tr("The controller did not answer"), detailOf(event)),
                EventWords::tr("Try again; if it stays silent, check the controller and the line."),
                Tone::Warn};
    default:
        return {};
    }
}

/// "leg 3 off by 25.1 mm, limit 24.0 mm", in the language of the screen.
QString followingText(const Event& event) {
    int leg = 0;
    char gap[24] = "";
    char limit[24] = "";
    if (std::sscanf(event.detail.c_str(), "leg %d off by %23s mm, limit %23s mm", &leg, gap, limit) != 3) {
        return withDetail(EventWords::tr("Stopped: a leg does not follow"), detailOf(event));
    }
    return EventWords::tr("Stopped: leg %1 is %2 mm from its set-point, more than %3 mm")
        .arg(QString::number(leg), QString::fromLatin1(gap), QString::fromLatin1(limit));
}

EventText stopText(const Event& event) {
    const QString clear = EventWords::tr("Find the cause, press Clear, then Run.");
    switch (event.code) {
    case EventCode::StopRequested:
        return {EventWords::tr("Stop"), EventWords::tr("Press Clear before the next Run."), Tone::Warn};
    case EventCode::StoppedByController:
        return {withDetail(EventWords::tr("The controller stopped the move"), controllerStateDetail(event)),
                clear, Tone::Bad};
    case EventCode::StoppedOnStaleData:
        return {EventWords::tr("Stopped: the measurements stayed away"), clear, Tone::Bad};
    case EventCode::StoppedOnSolver:
        return {withDetail(EventWords::tr("Stopped: the lengths gave no usable pose"), solverDetail(event)),
                clear, Tone::Bad};
    case EventCode::StoppedOnRefusal:
        return {withDetail(EventWords::tr("Stopped: the controller refused a set-point"), detailOf(event)),
                clear, Tone::Bad};
    case EventCode::StoppedOnFollowingError:
        return {followingText(event), clear, Tone::Bad};
    case EventCode::StoppedOnNoEcho:
        return {EventWords::tr("Stopped: the controller accepted no set-point for %1 ms")
                    .arg(fixed(event.value, 0)),
                clear, Tone::Bad};
    case EventCode::StoppedOnLimits:
        return {withDetail(EventWords::tr("Stopped: a set-point would have left a stroke"),
                           motionCheckTextFromWords(detailOf(event))),
                clear, Tone::Bad};
    case EventCode::StoppedOnNewIdentity:
        return {withDetail(EventWords::tr("Stopped: the controller gave another name or other limits"),
                           detailOf(event)),
                clear, Tone::Bad};
    case EventCode::StoppedAfterLoss:
        return {EventWords::tr("The link is back after a loss in mid-move: a stop was sent"), clear,
                Tone::Bad};
    case EventCode::DisableUnconfirmed:
        return {EventWords::tr("The controller did not confirm that the drives are off"),
                EventWords::tr("Look at the machine; take its drives off there."), Tone::Bad};
    case EventCode::LoopFailed:
        return {withDetail(EventWords::tr("The control loop ended"), detailOf(event)),
                EventWords::tr("Disconnect and connect again; keep the log for the maker."), Tone::Bad};
    case EventCode::ControllerFault:
        return {withDetail(EventWords::tr("Fault of the controller"), detailOf(event)),
                EventWords::tr("Remove the cause at the machine, then press Clear."), Tone::Bad};
    default:
        return {};
    }
}

EventText refusalText(const Event& event) {
    switch (event.code) {
    case EventCode::MoveRefused:
        return {withDetail(EventWords::tr("The move was refused"), moveRefusal(event)),
                liesAlongPath(detailOf(event))
                    ? EventWords::tr("Nothing moved. Go there in smaller steps or in the other mode.")
                    : EventWords::tr("Nothing moved. Change the target."),
                Tone::Warn};
    case EventCode::PreparationFailed:
        return {withDetail(EventWords::tr("The move did not begin: the platform could not be made ready"),
                           detailOf(event)),
                EventWords::tr("Press Reference or Enable and see what the controller answers."), Tone::Warn};
    case EventCode::ControllerRefused:
        return {withDetail(EventWords::tr("The controller refused"), detailOf(event)),
                EventWords::tr("See the controller's manual for the code."), Tone::Warn};
    case EventCode::CommandRefused:
        return {withDetail(EventWords::tr("The command cannot be carried out in this state"),
                           refusalDetail(event)),
                refusalAdvice(event), Tone::Warn};
    case EventCode::JogLimited:
        return {withDetail(EventWords::tr("The jog came to rest before a limit"),
                           motionCheckTextFromWords(detailOf(event))),
                EventWords::tr("Jog the other way, or along another axis."), Tone::Warn};
    case EventCode::NotSettled:
        return {EventWords::tr("The legs had not settled after %1 s").arg(fixed(event.value, 1)),
                EventWords::tr("Look at the leg errors: load, friction or a drive's gain may be the cause."),
                Tone::Warn};
    case EventCode::LogFailed:
        return {withDetail(EventWords::tr("The log cannot be written"), detailOf(event)),
                EventWords::tr("Free space on the disk, then connect again."), Tone::Bad};
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
        return {EventWords::tr("Move started, %1 s planned").arg(fixed(event.value, 1)), {}, Tone::Idle};
    case EventCode::JogStarted:
        return {EventWords::tr("Jog started"), {}, Tone::Idle};
    case EventCode::Settled:
        return {EventWords::tr("Settled after %1 s").arg(fixed(event.value, 1)), {}, Tone::Good};
    case EventCode::Cleared:
        return {EventWords::tr("Cleared"), EventWords::tr("Press Run when it is safe to move."), Tone::Idle};
    case EventCode::SolverChanged:
        return {EventWords::tr("The solver is now %1")
                    .arg(solverTitle(std::string_view(event.detail).substr(0, event.detail.find(' ')))),
                {},
                Tone::Idle};
    case EventCode::ReportSample:
        return {EventWords::tr("Sample %1 of the report taken").arg(fixed(event.value, 0)), {}, Tone::Idle};
    default:
        return {};
    }
}

} // namespace

EventText eventText(const Event& event) {
    for (const auto& group : {linkText, stopText, refusalText, progressText}) {
        if (EventText text = group(event); !text.cause.isEmpty()) {
            return text;
        }
    }
    const std::string_view word = toWord(event.code);
    return {withDetail(QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())), detailOf(event)),
            {},
            Tone::Idle};
}

} // namespace hexapose
