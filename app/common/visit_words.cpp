// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/common/visit_words.h"

#include "core/record/event_codec.h"

namespace hexapose {

namespace {

std::string within(std::chrono::seconds time) {
    return " within " + std::to_string(time.count()) + " s";
}

std::string wordsOf(const VisitFailure& failure, const VisitJob::Options& options) {
    switch (failure.reason) {
    case VisitFailure::Reason::NoAnswer:
        return "no controller answered" + within(options.answerWithin);
    case VisitFailure::Reason::UselessAnswer:
        return "no usable answer" + within(options.answerWithin) + ": " + payloadWords(*failure.event);
    case VisitFailure::Reason::TakesNoCommands:
        return "an unprotected sender of lengths takes no commands";
    case VisitFailure::Reason::NotReady:
        return "no pose of the platform" + within(options.readyWithin) + ": the solution of its lengths is " +
               std::string(toWord(failure.status)) + ", its state " + std::string(toWord(failure.state));
    case VisitFailure::Reason::Ended:
        return formatEvent(*failure.event);
    case VisitFailure::Reason::Interrupted:
        return "interrupted";
    }
    return {};
}

} // namespace

std::string failureWords(const VisitJob& job) {
    std::string words = job.failure() ? wordsOf(*job.failure(), job.options()) : std::string();
    for (const Event& event : job.closingFaults())
        words += (words.empty() ? "" : "; ") + formatEvent(event);
    return words;
}

} // namespace hexapose
