// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <initializer_list>
#include <string_view>

namespace hexapose {

/// What an operator can ask the machine for, as far as the machine's state decides whether it may.
enum class Command { Run, Jog, Stop, Reference, Enable, Disable, Clear, Hold, Resume };
inline constexpr std::array kCommands{Command::Run,    Command::Jog,     Command::Stop,
                                      Command::Reference, Command::Enable, Command::Disable,
                                      Command::Clear,  Command::Hold,    Command::Resume};

/// "run", "jog", ...: as the log names it.
constexpr std::string_view toWord(Command command) {
    constexpr std::array<std::string_view, kCommands.size()> kWords{
        "run", "jog", "stop", "reference", "enable", "disable", "clear", "hold", "resume"};
    return kWords[static_cast<std::size_t>(command)];
}

/// A set of commands: those that the machine would accept now.
class CommandSet {
public:
    constexpr CommandSet() = default;
    constexpr CommandSet(std::initializer_list<Command> commands) {
        for (const Command command : commands)
            insert(command);
    }
    constexpr void insert(Command command) { m_bits |= bit(command); }
    constexpr bool contains(Command command) const { return (m_bits & bit(command)) != 0; }
    constexpr bool operator==(const CommandSet&) const = default;

private:
    static constexpr unsigned bit(Command command) { return 1U << static_cast<unsigned>(command); }
    unsigned m_bits = 0;
};

} // namespace hexapose
