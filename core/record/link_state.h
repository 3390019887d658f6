// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace hexapose {

/// The connection to a controller.
enum class LinkState {
    Connecting, ///< open; the controller has not identified itself yet
    Connected,  ///< a controller that accepts commands
    ListenOnly, ///< an unprotected sender of lengths; accepts no commands
    Lost,       ///< the port is gone
};

/// Frames and lines counted since the connection was opened. A port that went and came back is the same
/// connection.
struct LinkCounters {
    std::uint64_t accepted = 0;       ///< good frames of every type, and listen-only lines
    std::uint64_t droppedCrc = 0;     ///< checksum wrong
    std::uint64_t droppedLength = 0;  ///< payload over 240 bytes, or a frame torn by the next '$'
    std::uint64_t droppedFields = 0;  ///< unknown type or wrong number of fields
    std::uint64_t droppedNumber = 0;  ///< a number outside the protocol's form or range, NaN among them
    std::uint64_t droppedGarbage = 0; ///< lines or runs of bytes outside a frame
    std::uint64_t droppedOrder = 0;   ///< repeated frame, or a controller clock that went back
    std::uint64_t missed = 0;         ///< frames that the controller counted and that never arrived

    std::uint64_t dropped() const {
        return droppedCrc + droppedLength + droppedFields + droppedNumber + droppedGarbage + droppedOrder;
    }
    LinkCounters& operator+=(const LinkCounters& other) {
        accepted += other.accepted;
        droppedCrc += other.droppedCrc;
        droppedLength += other.droppedLength;
        droppedFields += other.droppedFields;
        droppedNumber += other.droppedNumber;
        droppedGarbage += other.droppedGarbage;
        droppedOrder += other.droppedOrder;
        missed += other.missed;
        return *this;
    }
};

} // namespace hexapose
