// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/record/event.h"

#include <QString>

namespace hexapose {

/// What an event carries, for people; empty for a bare number or none. Texts of a controller or of the system
/// stay as they are.
QString payloadText(const EventData& data);

QString requestText(DeviceRequest request);
QString controllerStateText(ControllerState state);

} // namespace hexapose
