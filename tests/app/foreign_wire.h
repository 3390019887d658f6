// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The line protocol once more, from its description alone and on purpose without a line of core/device: two
/// sides that share code share mistakes.
namespace hexapose::apptest {

std::uint16_t foreignCrc(std::string_view payload);
std::string foreignHex(std::uint16_t crc);
/// '$' payload '*' CRC and the line end.
std::string foreignFrame(std::string_view payload, std::string_view lineEnd = "\n");

/// What a strict reader finds: frames, and bytes that are none.
class ForeignReader {
public:
    struct Item {
        std::optional<std::string> payload; ///< of a good frame
        std::string bytes;                  ///< as they came
    };
    std::vector<Item> feed(std::string_view bytes);

private:
    std::string m_line;
};

std::vector<std::string> splitFields(std::string_view payload);
/// -? digits, then at most six decimals.
bool isWireNumber(std::string_view text);

} // namespace hexapose::apptest
