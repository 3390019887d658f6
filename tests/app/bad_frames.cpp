// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/bad_frames.h"

#include "tests/app/foreign_wire.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>

namespace hexapose::apptest {

namespace {

struct Moment {
    LenFrame last;
    LenFrame next; ///< with wrong lengths
    int decimals;

    std::string payload() const { return next.payload(decimals); }
    /// The payload with one field replaced: 3 to 8 are the lengths.
    std::string with(std::size_t index, const std::string& text) const {
        std::vector<std::string> fields = splitFields(payload());
        fields[index] = text;
        std::string result;
        for (const std::string& field : fields)
            result += (result.empty() ? "" : ",") + field;
        return result;
    }
};

std::string swapCase(const Moment& m) {
    LenFrame frame = m.next;
    // A checksum without a letter looks the same in lower case.
    while (foreignHex(foreignCrc(frame.payload(m.decimals))).find_first_of("ABCDEF") == std::string::npos)
        frame.lengths[0] += 1.0;
    std::string text = foreignFrame(frame.payload(m.decimals));
    std::transform(text.end() - 6, text.end(), text.end() - 6,
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

using Deed = std::string (*)(const Moment&);

const std::array kDeeds = std::to_array<Deed>({
    [](const Moment&) { return std::string("\x00\xFF\x7F garbage \x1B[2J*12\r\r", 20); },
    [](const Moment&) { return std::string("boot: 3.3 V ok\n\n\xC3\xA4*,,,\n"); },
    [](const Moment& m) { return foreignFrame(m.payload()).substr(0, 30); }, // torn by the next '$'
    [](const Moment& m) { return foreignFrame(m.payload()).substr(0, 40) + "\n"; },
    [](const Moment& m) { return "$" + m.payload() + "*" + foreignHex(foreignCrc(m.payload()) ^ 1U) + "\n"; },
    [](const Moment& m) { return "$" + m.payload() + "*0000\n"; },
    swapCase,
    [](const Moment& m) { return "$" + m.payload() + "\n"; },
    [](const Moment& m) { return foreignFrame(m.payload()).substr(1); }, // lost its '$'
    [](const Moment& m) { return foreignFrame(m.payload(), " \n"); },
    [](const Moment& m) { return foreignFrame(m.with(3, "nan")); },
    [](const Moment& m) { return foreignFrame(m.with(8, "NaN")); },
    [](const Moment& m) { return foreignFrame(m.with(4, "inf")); },
    [](const Moment& m) { return foreignFrame(m.with(5, "3.1e2")); },
    [](const Moment& m) { return foreignFrame(m.with(5, "+310.5")); },
    [](const Moment& m) { return foreignFrame(m.with(5, " 310.5")); },
    [](const Moment& m) { return foreignFrame(m.with(5, "0x136")); },
    [](const Moment& m) { return foreignFrame(m.with(5, "310.1234567")); },
    [](const Moment& m) { return foreignFrame(m.with(6, "")); },
    [](const Moment& m) { return foreignFrame(m.with(6, "-310.5")); },
    [](const Moment& m) { return foreignFrame(m.with(9, "X")); },
    [](const Moment& m) { return foreignFrame(m.with(9, "EE")); },
    [](const Moment& m) { return foreignFrame(m.with(1, "65536")); },
    [](const Moment& m) { return foreignFrame(m.with(1, "1.5")); },
    [](const Moment& m) { return foreignFrame(m.with(2, "-1")); },
    [](const Moment& m) { return foreignFrame(m.with(10, "70000")); },
    [](const Moment& m) { return foreignFrame(m.payload() + ",310.5,310.5"); }, // 13 fields
    [](const Moment& m) { return foreignFrame(m.payload().substr(0, m.payload().rfind(','))); },
    [](const Moment& m) { return foreignFrame(m.payload() + "," + std::string(240, '1')); },
    [](const Moment& m) { return foreignFrame(m.with(9, "E$E")); },
    [](const Moment& m) { return foreignFrame("LENS" + m.payload().substr(3)); },
    [](const Moment& m) { return foreignFrame("len" + m.payload().substr(3)); },
    [](const Moment&) { return std::string("$*FFFF\n"); },
    [](const Moment&) { return std::string(3000, '#') + "\n"; },
    [](const Moment&) { return std::string("310.5,310.5,310.5,310.5,310.5,310.5\n"); }, // unprotected
    [](const Moment& m) { // the same number again
        LenFrame frame = m.next;
        frame.number = m.last.number;
        frame.microseconds = m.last.microseconds;
        return foreignFrame(frame.payload(m.decimals));
    },
    [](const Moment& m) { // the clock goes back, once
        LenFrame frame = m.next;
        frame.microseconds = std::max<std::int64_t>(0, m.last.microseconds - 100000);
        return foreignFrame(frame.payload(m.decimals));
    },
});

} // namespace

std::string LenFrame::payload(int decimals) const {
    std::string text = "LEN," + std::to_string(number) + "," + std::to_string(microseconds);
    for (const double length : lengths) {
        std::array<char, 32> digits{};
        std::snprintf(digits.data(), digits.size(), ",%.*f", decimals, length);
        text += digits.data();
    }
    return text + "," + state + "," + std::to_string(setNumber);
}

std::size_t badFrameCount() {
    return kDeeds.size();
}

std::string badFrame(std::size_t index, const LenFrame& last, const LenFrame& next, int decimals) {
    Moment moment{last, next, decimals};
    for (double& length : moment.next.lengths)
        length = 620.0 - length; // on the other side of the stroke, and another value for every frame
    return kDeeds.at(index % kDeeds.size())(moment);
}

} // namespace hexapose::apptest
