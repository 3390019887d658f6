// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/allowed_commands.h"

namespace hexapose {

CommandSet allowedCommands(const Snapshot& snapshot) {
    if (snapshot.link != LinkState::Connected) {
        return {};
    }
    switch (snapshot.state) {
    case RunState::Unreferenced:
        return {Command::Run, Command::Stop, Command::Reference, Command::Disable};
    case RunState::Disabled:
        return {Command::Run, Command::Stop, Command::Reference, Command::Enable, Command::Disable};
    case RunState::Enabled:
    case RunState::Settling:
        return {Command::Run, Command::Jog, Command::Stop, Command::Disable};
    case RunState::Moving:
        return {Command::Stop, Command::Disable};
    case RunState::Stopped:
    case RunState::Fault:
        return {Command::Stop, Command::Disable, Command::Clear};
    case RunState::Disconnected:
        break;
    }
    return {};
}

} // namespace hexapose
