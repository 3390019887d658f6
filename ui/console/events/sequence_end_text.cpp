// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/events/sequence_end_text.h"

#include "ui/console/events/event_text.h"

#include <QCoreApplication>

namespace hexapose {

namespace {
struct SequenceEnd {
    Q_DECLARE_TR_FUNCTIONS(hexapose::SequenceEnd)
};
} // namespace

QString sequenceEndText(const PoseSequence& sequence) {
    const Event cause = sequence.failure().value_or(Event{EventCode::NotSettled});
    const bool another = cause.code == EventCode::MoveStarted || cause.code == EventCode::JogStarted;
    return another ? SequenceEnd::tr("another motion was commanded") : eventText(cause).cause;
}

} // namespace hexapose
