// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/line_message.h"

#include "core/device/line/line_requests.h"
#include "core/device/line/wire_number.h"
#include "core/device/line/wire_words.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace hexapose::line {
namespace {

constexpr double kWireExact = 1e-15; ///< m, round-off of a length written in mm

TEST(Messages, SurviveTheWire) {
    LegLengths lengths;
    lengths << 0.3395, 0.3365, 0.336600001, 0.1, 1.5, 0.25;
    const std::vector<LineMessage> toHost{
        Len{65535, std::chrono::microseconds(123456789012), lengths, ControllerState::Stopped, 65535},
        Ident{"arm", std::chrono::milliseconds(20), 0.25, 0.3505}, Ok{"HOME"},
        Err{"SET", "RANGE", "leg 1, long"}, Fault{"7", "hot, very"}};
    const std::vector<LineMessage> toController{
        Hello{}, Period{std::chrono::milliseconds(5)}, Home{}, Enable{}, Disable{}, Set{7, lengths}, Stop{},
        Clear{}};
    for (const auto& [side, messages] :
         {std::pair(Side::Host, toHost), std::pair(Side::Controller, toController)})
        for (const LineMessage& message : messages) {
            const LineMessage read = parsePayload(payloadOf(message), side);
            EXPECT_EQ(read.index(), message.index());
            EXPECT_EQ(payloadOf(read), payloadOf(message));
        }
    const LineMessage read = parsePayload(payloadOf(toHost[0]), Side::Host);
    EXPECT_LT((std::get<Len>(read).lengths - lengths).norm(), kWireExact);
    EXPECT_EQ(payloadOf(Set{0, lengths}), "SET,0,339.5,336.5,336.600001,100,1500,250");
}

/// A controller is in one of the states of the protocol; the '?' of a log is none, and no other letter
/// either.
TEST(Messages, AMeasurementTellsAStateOfTheProtocol) {
    const auto len = [](char state) {
        return parsePayload(std::string("LEN,1,1000,300,300,300,300,300,300,") + state + ",-1", Side::Host);
    };
    const std::string states = "UDESF";
    for (char letter = ' '; letter <= '~'; ++letter) {
        const LineMessage read = len(letter);
        if (states.find(letter) != std::string::npos)
            EXPECT_EQ(toLetter(std::get<Len>(read).state), letter);
        else
            EXPECT_TRUE(std::holds_alternative<Malformed>(read)) << letter;
    }
}

/// The words of answers are the protocol's, whatever the log calls a request.
TEST(Messages, AnswersNameTheRequestAsItsMessageDoes) {
    for (const DeviceRequest request : {DeviceRequest::Reference, DeviceRequest::Enable,
                                        DeviceRequest::Disable, DeviceRequest::Stop, DeviceRequest::Clear})
        EXPECT_EQ(requestOfType(payloadOf(*messageOf(request))), request);
    const std::pair<LineMessage, DeviceRequest> others[] = {{Set{}, DeviceRequest::SetPoint},
                                                            {Period{}, DeviceRequest::Period},
                                                            {Hello{}, DeviceRequest::Hello},
                                                            {Ident{}, DeviceRequest::Identity}};
    for (const auto& [message, request] : others) {
        const std::string payload = payloadOf(message);
        EXPECT_EQ(requestOfType(payload.substr(0, payload.find(','))), request) << payload;
    }
    for (const char* none : {"", "home", "HOM", "OK", "LEN"})
        EXPECT_EQ(requestOfType(none), DeviceRequest::Other) << none;
    EXPECT_EQ(reasonOfCode("STATE"), RefusalReason::State);
    EXPECT_EQ(reasonOfCode("RANGE"), RefusalReason::Range);
    EXPECT_EQ(reasonOfCode("FORMAT"), RefusalReason::Format);
    EXPECT_EQ(reasonOfCode("state"), RefusalReason::Other);
}

TEST(PendingRequests, AreAnsweredOrOverdueOnce) {
    using namespace std::chrono_literals;
    const PendingRequests::Time begin{};
    PendingRequests pending;
    pending.sent(DeviceRequest::Enable, begin);
    pending.sent(DeviceRequest::Period, begin + 500ms);
    pending.sent(DeviceRequest::Clear, begin);
    EXPECT_TRUE(pending.answered(DeviceRequest::Clear));
    EXPECT_FALSE(pending.answered(DeviceRequest::Clear));
    EXPECT_FALSE(pending.answered(DeviceRequest::Other));
    EXPECT_EQ(pending.takeOverdue(begin + 1001ms, 1000ms), std::vector{DeviceRequest::Enable});
    EXPECT_FALSE(pending.waitsFor(DeviceRequest::Enable));
    EXPECT_TRUE(pending.waitsFor(DeviceRequest::Period));
}

TEST(WireNumbers, AreShortPlainDecimals) {
    const std::pair<double, const char*> rows[] = {
        {339.5, "339.5"}, {-0.0, "0"},           {-1e-9, "0"},   {1e-6, "0.000001"},
        {100.0, "100"},   {1.0 / 3, "0.333333"}, {-2.5, "-2.5"}, {1e15, "1000000000000000"}};
    for (const auto& [value, text] : rows)
        EXPECT_EQ(formatWireDecimal(value), text);
    EXPECT_EQ(parseWireDecimal("-12.25"), -12.25);
    EXPECT_FALSE(parseWireDecimal(std::string(400, '9'))); // beyond a double
    for (const char* text : {"", "-", "--1", "1-", "1.2.3", "1e5", "nan", "1,5", "\xd9\xa1"})
        EXPECT_FALSE(parseWireDecimal(text)) << text;
    EXPECT_EQ(parseWireInteger("-9223372036854775808"), std::numeric_limits<long long>::min());
    EXPECT_FALSE(parseWireInteger("9223372036854775808"));
}

} // namespace
} // namespace hexapose::line
