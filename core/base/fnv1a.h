// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace hexapose {

/// The 64-bit FNV-1a hash: fingerprints and checksums. Tells altered data, not a forger.
class Fnv1a {
public:
    constexpr void addByte(unsigned char byte) noexcept { m_state = (m_state ^ byte) * 0x100000001b3ULL; }
    constexpr void add(std::string_view bytes) noexcept {
        for (const char c : bytes)
            addByte(static_cast<unsigned char>(c));
    }
    constexpr void add(std::uint64_t value) noexcept {
        for (int shift = 0; shift < 64; shift += 8)
            addByte(static_cast<unsigned char>((value >> shift) & 0xffU));
    }
    /// The bits of the number, lowest byte first whatever the processor; -0 counts as 0.
    constexpr void add(double value) noexcept {
        add(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value));
    }

    constexpr std::uint64_t value() const noexcept { return m_state; }
    /// 16 hex digits, lower case.
    std::string hex() const {
        std::string text(16, '0');
        for (int i = 0; i < 16; ++i)
            text[static_cast<std::size_t>(i)] = "0123456789abcdef"[(m_state >> (60 - 4 * i)) & 0xfU];
        return text;
    }

private:
    std::uint64_t m_state = 0xcbf29ce484222325ULL;
};

} // namespace hexapose
