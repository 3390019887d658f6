// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/line_codec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace hexapose::line {
namespace {

constexpr std::string_view kLen = "LEN,1,1000,339.5,336.5,336.6,329.2,345.1,334.5,E,-1";

struct Read {
    std::vector<LineMessage> messages;
    LinkCounters counters;
    std::vector<std::string> payloads() const {
        std::vector<std::string> all;
        for (const LineMessage& message : messages)
            all.push_back(payloadOf(message));
        return all;
    }
};

Read readAll(std::string_view bytes, Side side = Side::Host, std::size_t piece = 0) {
    FrameReader reader(side);
    reader.noteIdle();
    Read read;
    if (piece == 0)
        piece = std::max<std::size_t>(bytes.size(), 1);
    for (std::size_t at = 0; at < bytes.size(); at += piece)
        reader.feed(bytes.substr(at, piece), read.messages);
    read.counters = reader.counters();
    return read;
}

std::string counts(const LinkCounters& c) {
    std::string text;
    const std::pair<const char*, std::uint64_t> all[] = {
        {"accepted", c.accepted},    {"crc", c.droppedCrc},       {"length", c.droppedLength},
        {"fields", c.droppedFields}, {"number", c.droppedNumber}, {"garbage", c.droppedGarbage}};
    for (const auto& [name, value] : all)
        if (value > 0)
            text += (text.empty() ? "" : " ") + std::string(name) + std::to_string(value);
    return text;
}

TEST(Crc16, GivesThePublishedCheckValue) {
    EXPECT_EQ(crc16("123456789"), 0x29B1);
    EXPECT_EQ(frame("123456789"), "$123456789*29B1\n");
}

struct Row {
    const char* what;
    std::string bytes;
    std::string expectedCounts;
    Side side = Side::Host;
};

void PrintTo(const Row& row, std::ostream* out) {
    *out << row.what;
}

class Rows : public testing::TestWithParam<Row> {};

TEST_P(Rows, AreJudgedAlikeHoweverTheyAreCut) {
    const Read whole = readAll(GetParam().bytes, GetParam().side);
    EXPECT_EQ(counts(whole.counters), GetParam().expectedCounts);
    for (const std::size_t piece : {1U, 2U, 3U, 7U, 64U}) {
        const Read cut = readAll(GetParam().bytes, GetParam().side, piece);
        EXPECT_EQ(cut.payloads(), whole.payloads()) << piece;
        EXPECT_EQ(counts(cut.counters), counts(whole.counters)) << piece;
    }
}

std::string with(std::string_view from, std::string_view to, std::string payload = std::string(kLen)) {
    payload.replace(payload.find(from), from.size(), to);
    return frame(payload);
}

/// The checksum's letters in lower case.
std::string hexLower(std::string text) {
    for (std::size_t i = text.find('*'); i < text.size(); ++i)
        if (text[i] >= 'A' && text[i] <= 'F')
            text[i] = static_cast<char>(text[i] - 'A' + 'a');
    return text;
}

const std::string kGood = frame(kLen);
const std::string kPlain = "339.5,336.5,336.6,329.2,345.1,334.5\n";

INSTANTIATE_TEST_SUITE_P(
    Frames, Rows,
    testing::Values(Row{"good", kGood, "accepted1"},
                    Row{"carriage return before the line feed", kGood.substr(0, kGood.size() - 1) + "\r\n",
                        "accepted1"},
                    Row{"two carriage returns", kGood.substr(0, kGood.size() - 1) + "\r\r\n", "crc1"},
                    Row{"two in a row, blank lines between", kGood + "\r\n\n" + kGood, "accepted2"},
                    Row{"checksum wrong", "$" + std::string(kLen) + "*0000\n", "crc1"},
                    Row{"checksum missing", "$" + std::string(kLen) + "\n", "crc1"},
                    Row{"shorter than a checksum", "$*\n$\n", "crc2"},
                    Row{"torn by the next", kGood.substr(0, 20) + kGood, "accepted1 length1"},
                    Row{"dollar inside", "$LEN,1$LEN,2" + kGood, "accepted1 length2"},
                    Row{"garbage before a frame", "\x01\xff noise" + kGood, "accepted1 garbage1"},
                    Row{"garbage line", "hello\n" + kGood, "accepted1 garbage1"},
                    Row{"240 bytes of payload", frame("FAULT,1," + std::string(232, 'x')), "accepted1"},
                    Row{"241 bytes of payload", frame("FAULT,1," + std::string(233, 'x')), "length1"},
                    Row{"endless payload", "$" + std::string(5000, 'x') + "\n" + kGood, "accepted1 length1"},
                    Row{"endless garbage", std::string(5000, 'x') + "\n" + kGood, "accepted1 garbage1"},
                    Row{"not ASCII", frame("FAULT,1,\xc3\xa4"), "fields1"},
                    Row{"control character", frame("FAULT,1,\t"), "fields1"},
                    Row{"unknown type", frame("SPEED,1"), "fields1"},
                    Row{"empty payload", frame(""), "fields1"},
                    Row{"type in lower case", with("LEN", "len"), "fields1"},
                    Row{"one field less", with(",334.5", ""), "fields1"},
                    Row{"one field more", with(",E", ",1,E"), "fields1"},
                    Row{"unknown state", with(",E", ",X"), "fields1"},
                    Row{"state too long", with(",E", ",EE"), "fields1"}));

INSTANTIATE_TEST_SUITE_P(
    Numbers, Rows,
    testing::Values(
        Row{"NaN", with("336.5", "nan"), "number1"}, Row{"infinity", with("336.5", "inf"), "number1"},
        Row{"exponent", with("336.5", "3.365e2"), "number1"}, Row{"plus", with("336.5", "+336.5"), "number1"},
        Row{"decimal comma is a field", with("336.5", "336,5"), "fields1"},
        Row{"blank before", with("336.5", " 336.5"), "number1"},
        Row{"blank behind", with("336.5", "336.5 "), "number1"},
        Row{"six decimals", with("336.5", "336.500001"), "accepted1"},
        Row{"seven decimals", with("336.5", "336.5000001"), "number1"},
        Row{"no decimals", with("336.5", "336"), "accepted1"},
        Row{"point without decimals", with("336.5", "336."), "number1"},
        Row{"point without whole", with("336.5", ".5"), "number1"},
        Row{"hexadecimal", with("336.5", "0x10"), "number1"}, Row{"empty", with("336.5", ""), "number1"},
        Row{"zero length", with("336.5", "0"), "number1"},
        Row{"negative length", with("336.5", "-336.5"), "number1"},
        Row{"n at its end", with("LEN,1,", "LEN,65535,"), "accepted1"},
        Row{"n too large", with("LEN,1,", "LEN,65536,"), "number1"},
        Row{"n negative", with("LEN,1,", "LEN,-1,"), "number1"},
        Row{"n with decimals", with("LEN,1,", "LEN,1.0,"), "number1"},
        Row{"large clock", with(",1000,", ",9223372036854775807,"), "accepted1"},
        Row{"clock beyond 64 bits", with(",1000,", ",99999999999999999999,"), "number1"},
        Row{"clock negative", with(",1000,", ",-1,"), "number1"},
        Row{"set n at its end", with("E,-1", "E,65535"), "accepted1"},
        Row{"set n too small", with("E,-1", "E,-2"), "number1"},
        Row{"set n too large", with("E,-1", "E,65536"), "number1"}));

INSTANTIATE_TEST_SUITE_P(
    Answers, Rows,
    testing::Values(Row{"ident", frame("IDENT,1,a name,6,10,250,350"), "accepted1"},
                    Row{"ident with decimals", frame("IDENT,1,x,6,8.5,250.25,350.75"), "accepted1"},
                    Row{"ident of another version", frame("IDENT,2,x,6,10,250,350,more"), "fields1"},
                    Row{"ident of five legs", frame("IDENT,1,x,5,10,250,350"), "fields1"},
                    Row{"ident with a comma in the name", frame("IDENT,1,a,b,6,10,250,350"), "fields1"},
                    Row{"ident with limits the wrong way", frame("IDENT,1,x,6,10,350,250"), "number1"},
                    Row{"ident without period", frame("IDENT,1,x,6,0,250,350"), "number1"},
                    Row{"ok", frame("OK,STOP"), "accepted1"},
                    Row{"ok of two", frame("OK,STOP,HOME"), "fields1"},
                    Row{"error with commas in its text", frame("ERR,SET,RANGE,leg 1, 400 mm, too long"),
                        "accepted1"},
                    Row{"error without text", frame("ERR,SET,RANGE"), "fields1"},
                    Row{"fault", frame("FAULT,7,hot, very"), "accepted1"},
                    Row{"fault without text", frame("FAULT,7"), "fields1"},
                    Row{"a host's message at the host", frame("STOP"), "fields1"}));

INSTANTIATE_TEST_SUITE_P(
    Requests, Rows,
    testing::Values(Row{"hello", frame("HELLO,1"), "accepted1", Side::Controller},
                    Row{"hello of another version", frame("HELLO,2"), "number1", Side::Controller},
                    Row{"period", frame("PERIOD,1000"), "accepted1", Side::Controller},
                    Row{"period too long", frame("PERIOD,1001"), "number1", Side::Controller},
                    Row{"period with decimals", frame("PERIOD,10.5"), "number1", Side::Controller},
                    Row{"bare ones",
                        frame("HOME") + frame("ENABLE") + frame("DISABLE") + frame("STOP") + frame("CLEAR"),
                        "accepted5", Side::Controller},
                    Row{"bare one with a field", frame("STOP,1"), "fields1", Side::Controller},
                    Row{"set", frame("SET,65535,1,-2,3.5,4,5,6"), "accepted1", Side::Controller},
                    Row{"set of five", frame("SET,1,1,2,3,4,5"), "fields1", Side::Controller},
                    Row{"set of a NaN", frame("SET,1,1,2,3,4,5,nan"), "number1", Side::Controller},
                    Row{"bare lengths", kPlain, "garbage1", Side::Controller}));

INSTANTIATE_TEST_SUITE_P(PlainLines, Rows,
                         testing::Values(Row{"commas", kPlain, "accepted1"},
                                         Row{"blanks, tabs, CR", " 1  2\t3 4\t 5 6 \r\n", "accepted1"},
                                         Row{"semicolons and blanks", "1; 2 ;3;4;5;6\n", "accepted1"},
                                         Row{"five", "1,2,3,4,5\n", "garbage1"},
                                         Row{"seven", "1,2,3,4,5,6,7\n", "garbage1"},
                                         Row{"empty field", "1,,2,3,4,5,6\n", "garbage1"},
                                         Row{"trailing comma", "1,2,3,4,5,6,\n", "garbage1"},
                                         Row{"word", "1,2,3,4,5,nan\n", "garbage1"},
                                         Row{"zero", "1,2,3,4,5,0\n", "number1"},
                                         Row{"cut by a frame", "1,2,3,4,5,6" + kGood, "accepted1 garbage1"},
                                         Row{"after a good frame", kGood + kPlain, "accepted1 garbage1"},
                                         Row{"after a bad frame", "$x*0000\n" + kPlain, "accepted1 crc1"}));

TEST(FrameReader, TakesTheUpperCaseChecksumOnly) {
    std::string text = "OK,A";
    while (hexLower(frame(text)) == frame(text))
        text += 'A';
    EXPECT_EQ(counts(readAll(frame(text)).counters), "accepted1");
    EXPECT_EQ(counts(readAll(hexLower(frame(text))).counters), "crc1");
}

TEST(FrameReader, LeavesOutABareLineWhoseBeginningItMayHaveMissed) {
    std::vector<LineMessage> messages;
    FrameReader reader(Side::Host);
    reader.feed("9.5,336.5,336.6,329.2,345.1,334.5\n", messages); // of 339.5
    EXPECT_TRUE(messages.empty());
    reader.feed(kPlain, messages);
    EXPECT_EQ(messages.size(), 1U);
    FrameReader late(Side::Host);
    late.feed("9.5,", messages);
    late.noteIdle(); // a pause within a line proves nothing
    late.feed("336.5,336.6,329.2,345.1,334.5\n", messages);
    EXPECT_EQ(messages.size(), 1U);
}

/// Spoils a stream in every way a line can: bits flipped, bytes lost, inserted, runs repeated.
std::string spoil(std::string bytes, std::mt19937& random) {
    const auto below = [&](std::size_t bound) { return random() % bound; };
    for (int i = 0; i < 400; ++i) {
        const std::size_t at = below(bytes.size());
        switch (below(4)) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
            break;
        case 1:
            bytes.erase(at, 1 + below(30));
            break;
        case 2:
            bytes.insert(at, 1 + below(5), static_cast<char>(below(256)));
            break;
        default:
            bytes.insert(at, bytes.substr(below(bytes.size()), below(90)));
        }
    }
    return bytes;
}

TEST(FrameReader, NeverGivesAMessageThatWasNotSent) {
    std::mt19937 random(20260217);
    std::uint64_t accepted = 0;
    for (int round = 0; round < 6; ++round) {
        std::string stream;
        std::set<std::string> sent;
        for (int n = 0; n < 1000; ++n) {
            Len len{static_cast<std::uint16_t>(n), std::chrono::microseconds(10000 * n + 1),
                    LegLengths::Zero(), ControllerState::Enabled, n};
            for (double& length : len.lengths)
                length = 0.2 + 1e-4 * static_cast<double>(random() % 1000);
            sent.insert(payloadOf(len));
            stream += encode(len);
        }
        const std::string spoilt = spoil(stream, random);
        const Read whole = readAll(spoilt);
        for (const std::string& payload : whole.payloads())
            ASSERT_TRUE(sent.count(payload)) << payload;
        accepted += whole.counters.accepted;
        EXPECT_GT(whole.counters.dropped(), 0U);
        const Read cut = readAll(spoilt, Side::Host, 1 + random() % 100);
        EXPECT_EQ(cut.payloads(), whole.payloads());
        EXPECT_EQ(counts(cut.counters), counts(whole.counters));
    }
    EXPECT_GT(accepted, 3000U); // most frames of a spoilt stream still arrive
}

} // namespace
} // namespace hexapose::line
