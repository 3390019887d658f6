// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/wire_words.h"

#include <array>
#include <utility>

namespace hexapose::line {

namespace {

constexpr std::array<std::pair<std::string_view, DeviceRequest>, 9> kTypes{{
    {"SET", DeviceRequest::SetPoint},
    {"HOME", DeviceRequest::Reference},
    {"ENABLE", DeviceRequest::Enable},
    {"DISABLE", DeviceRequest::Disable},
    {"STOP", DeviceRequest::Stop},
    {"CLEAR", DeviceRequest::Clear},
    {"PERIOD", DeviceRequest::Period},
    {"HELLO", DeviceRequest::Hello},
    {"IDENT", DeviceRequest::Identity},
}};

constexpr std::array<std::pair<std::string_view, RefusalReason>, 3> kCodes{{
    {"STATE", RefusalReason::State},
    {"RANGE", RefusalReason::Range},
    {"FORMAT", RefusalReason::Format},
}};

} // namespace

DeviceRequest requestOfType(std::string_view type) {
    for (const auto& [word, request] : kTypes)
        if (word == type)
            return request;
    return DeviceRequest::Other;
}

RefusalReason reasonOfCode(std::string_view code) {
    for (const auto& [word, reason] : kCodes)
        if (word == code)
            return reason;
    return RefusalReason::Other;
}

} // namespace hexapose::line
