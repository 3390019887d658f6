// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/foreign_wire.h"

#include <array>
#include <cstdio>
#include <regex>

namespace hexapose::apptest {

std::uint16_t foreignCrc(std::string_view payload) {
    // Four bits at a time.
    static constexpr std::array<std::uint16_t, 16> kNibbles{0x0000, 0x1021, 0x2042, 0x3063, 0x4084, 0x50A5,
                                                            0x60C6, 0x70E7, 0x8108, 0x9129, 0xA14A, 0xB16B,
                                                            0xC18C, 0xD1AD, 0xE1CE, 0xF1EF};
    unsigned crc = 0xFFFF;
    for (const char c : payload) {
        const auto byte = static_cast<unsigned char>(c);
        crc = ((crc << 4U) & 0xFFFFU) ^ kNibbles[(crc >> 12U) ^ (byte >> 4U)];
        crc = ((crc << 4U) & 0xFFFFU) ^ kNibbles[(crc >> 12U) ^ (byte & 0xFU)];
    }
    return static_cast<std::uint16_t>(crc);
}

std::string foreignHex(std::uint16_t crc) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "%04X", static_cast<unsigned>(crc));
    return text.data();
}

std::string foreignFrame(std::string_view payload, std::string_view lineEnd) {
    return "$" + std::string(payload) + "*" + foreignHex(foreignCrc(payload)) + std::string(lineEnd);
}

std::vector<ForeignReader::Item> ForeignReader::feed(std::string_view bytes) {
    std::vector<Item> items;
    for (const char c : bytes) {
        if (c == '$' && !m_line.empty()) {
            items.push_back({std::nullopt, m_line});
            m_line.clear();
        }
        m_line += c;
        if (c != '\n')
            continue;
        static const std::regex form("\\$([\\x20-\\x7E]{1,240})\\*([0-9A-F]{4})\r?\n");
        std::smatch match;
        if (std::regex_match(m_line, match, form) && foreignHex(foreignCrc(match[1].str())) == match[2])
            items.push_back({match[1].str(), m_line});
        else
            items.push_back({std::nullopt, m_line});
        m_line.clear();
    }
    return items;
}

std::vector<std::string> splitFields(std::string_view payload) {
    std::vector<std::string> fields(1);
    for (const char c : payload) {
        if (c == ',')
            fields.emplace_back();
        else
            fields.back() += c;
    }
    return fields;
}

bool isWireNumber(std::string_view text) {
    static const std::regex form("-?[0-9]+(\\.[0-9]{1,6})?");
    return std::regex_match(text.begin(), text.end(), form);
}

} // namespace hexapose::apptest
