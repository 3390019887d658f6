// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/status_text.h"

#include "core/base/units.h"
#include "core/kinematics/catalog/forward_methods.h"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

namespace hexapose {

namespace {
struct StatusText {
    Q_DECLARE_TR_FUNCTIONS(hexapose::StatusText)
};
} // namespace

QString stateText(RunState state) {
    switch (state) {
    case RunState::Disconnected:
        return StatusText::tr("Disconnected");
    case RunState::Unreferenced:
        return StatusText::tr("Not referenced");
    case RunState::Disabled:
        return StatusText::tr("Disabled");
    case RunState::Enabled:
        return StatusText::tr("Enabled");
    case RunState::Moving:
        return StatusText::tr("Moving");
    case RunState::Settling:
        return StatusText::tr("Settling");
    case RunState::Stopped:
        return StatusText::tr("Stopped");
    case RunState::Fault:
        return StatusText::tr("Fault");
    }
    return {};
}

Tone stateTone(RunState state) {
    switch (state) {
    case RunState::Enabled:
    case RunState::Moving:
    case RunState::Settling:
        return Tone::Good;
    case RunState::Stopped:
        return Tone::Warn;
    case RunState::Fault:
        return Tone::Bad;
    case RunState::Disconnected:
    case RunState::Unreferenced:
    case RunState::Disabled:
        break;
    }
    return Tone::Idle;
}

namespace {

enum class Known { Yes, NoData, NotReported };

Known knownState(const Snapshot& snapshot) {
    if (snapshot.state == RunState::Disconnected) {
        return Known::Yes;
    }
    if (snapshot.link == LinkState::ListenOnly) {
        return Known::NotReported;
    }
    // A stop of our own, or the end of the loop, is known without the controller.
    const bool own = snapshot.state == RunState::Stopped || snapshot.state == RunState::Fault;
    return snapshot.stale && !own ? Known::NoData : Known::Yes;
}

} // namespace

QString stateText(const Snapshot& snapshot) {
    switch (knownState(snapshot)) {
    case Known::NoData:
        return StatusText::tr("No data");
    case Known::NotReported:
        return StatusText::tr("Not known");
    case Known::Yes:
        break;
    }
    return stateText(snapshot.state);
}

Tone stateTone(const Snapshot& snapshot) {
    return knownState(snapshot) == Known::Yes ? stateTone(snapshot.state) : Tone::Warn;
}

QString runInhibit(const Snapshot& snapshot) {
    if (const QString link = linkInhibit(snapshot); !link.isEmpty()) {
        return link;
    }
    if (snapshot.state == RunState::Disconnected || snapshot.allowed.contains(Command::Run)) {
        return {};
    }
    switch (snapshot.state) {
    case RunState::Moving:
        return StatusText::tr("Cannot run while the platform moves");
    case RunState::Stopped:
    case RunState::Fault:
        return StatusText::tr("Cannot run: press Clear first");
    default:
        return snapshot.link == LinkState::Connected
                   ? StatusText::tr("Cannot run: a motion is being prepared")
                   : StatusText::tr("Cannot run: the controller does not answer yet");
    }
}

QString linkInhibit(const Snapshot& snapshot) {
    if (snapshot.state == RunState::Disconnected) {
        return {};
    }
    if (snapshot.link == LinkState::ListenOnly) {
        return StatusText::tr("Cannot run: this sender takes no commands");
    }
    return snapshot.stale ? StatusText::tr("Cannot run: no valid measurement received") : QString();
}

QString solveStatusText(SolveStatus status) {
    switch (status) {
    case SolveStatus::Converged:
        return StatusText::tr("Converged");
    case SolveStatus::IterationLimit:
        return StatusText::tr("Iteration limit reached");
    case SolveStatus::Singular:
        return StatusText::tr("Singular");
    case SolveStatus::NoSolution:
        return StatusText::tr("No pose of these lengths was found");
    case SolveStatus::InvalidInput:
        return StatusText::tr("Invalid lengths");
    case SolveStatus::OutsideModel:
        return StatusText::tr("Outside the model's range");
    case SolveStatus::OtherBranch:
        return StatusText::tr("Pose of another assembly mode");
    }
    return {};
}

QString solverTitle(std::string_view word) {
    if (word == "fsi") {
        return QStringLiteral("FSI");
    }
    const ForwardMethod* method = findForwardMethod(word);
    const std::string_view title = method != nullptr ? method->title : word;
    return QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size()));
}

const std::array<CoordinateText, 6>& coordinateTexts() {
    static const QString mm = QStringLiteral("mm");
    static const QString degree = QString::fromUtf8("\u00b0");
    static const std::array<CoordinateText, 6> texts = {{
        {QStringLiteral("x"), QStringLiteral("x"), mm, false},
        {QStringLiteral("y"), QStringLiteral("y"), mm, false},
        {QStringLiteral("z"), QStringLiteral("z"), mm, false},
        {QString::fromUtf8("\u03b1"), QStringLiteral("alpha"), degree, true},
        {QString::fromUtf8("\u03b2"), QStringLiteral("beta"), degree, true},
        {QString::fromUtf8("\u03b3"), QStringLiteral("gamma"), degree, true},
    }};
    return texts;
}

double toDisplay(int coordinate, double si) {
    return coordinate < 3 ? mmFromMetres(si) : degFromRadians(si);
}

double fromDisplay(int coordinate, double shown) {
    return coordinate < 3 ? metresFromMm(shown) : radiansFromDeg(shown);
}

double displayError(int coordinate, double measured, double target) {
    const double error = measured - target;
    return toDisplay(coordinate, coordinate < 3 ? error : std::remainder(error, 2.0 * std::numbers::pi));
}

} // namespace hexapose
