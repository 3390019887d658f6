// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/record/event.h"
#include "ui/common/theme.h"

#include <QString>

namespace hexapose {

/// An event for people: what happened and why, and what to do about it (empty when nothing is to be done).
struct EventText {
    QString cause;
    QString advice;
    Tone tone = Tone::Idle;
};
EventText eventText(const Event& event);
/// What ended the control loop, of LoopFailed. Words of the program or of the system are quoted.
QString loopFailureText(const Event& event);

} // namespace hexapose
