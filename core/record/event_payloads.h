// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/event.h"

#include <string>
#include <string_view>

/// The payloads of events in the words of the log.
namespace hexapose::payload {

/// Which payload an event code carries.
enum class Form {
    None,
    Number,
    Text,
    Port,
    MotionCheck,
    MoveRefusal, ///< MotionCheck, MotionInhibit or SweepFault
    Command,
    ControllerState,
    SolveStatus,
    Refusal,
    Request,
    CommandRefusal,
    FollowingError,
    Preparation,
    Identity,
    Solver,
    LogFailure,
    LogSpace,
    LogContinuation,
};

std::string toWords(const EventData& data);
/// DeviceText where the words are not of this form; nothing for none.
EventData fromWords(Form form, std::string_view words);

} // namespace hexapose::payload
