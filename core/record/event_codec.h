// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/event.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// The codes are 0 .. this - 1.
std::size_t eventCodeCount();
/// "move-started", ...: stable identifier of an event.
std::string_view toWord(EventCode code);
std::optional<EventCode> eventCodeFromWord(std::string_view word);

/// The payload in the log's words, on one line: "1.25", "leg 3 above max_mm"; empty without one.
std::string payloadWords(const Event& event);
/// The word of the code, then the payload: "settled 1.25", "move-refused leg 3 above max_mm".
std::string formatEvent(const Event& event);
/// The inverse; nothing when the text does not begin with a known word. A payload that is not of the code's
/// form is kept as DeviceText.
std::optional<Event> parseEvent(std::string_view text);

/// One field of the log: the events of a cycle, separated by "; ".
std::string formatEvents(const std::vector<Event>& events);
/// The events of such a field. Text that begins with no known word belongs to the payload of the event before
/// it, and is passed over at the beginning.
std::vector<Event> parseEvents(std::string_view field);

} // namespace hexapose
