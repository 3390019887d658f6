// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/units.h"
#include "core/device/line/line_message.h"
#include "core/device/line/wire_number.h"

namespace hexapose::line {

namespace {

std::string withLengths(std::string text, const LegLengths& lengths) {
    for (const double length : lengths)
        text += ',' + formatWireDecimal(mmFromMetres(length));
    return text;
}

struct Formatter {
    std::string operator()(const Hello&) const { return "HELLO,1"; }
    std::string operator()(const Period& m) const { return "PERIOD," + std::to_string(m.period.count()); }
    std::string operator()(const Home&) const { return "HOME"; }
    std::string operator()(const Enable&) const { return "ENABLE"; }
    std::string operator()(const Disable&) const { return "DISABLE"; }
    std::string operator()(const Set& m) const {
        return withLengths("SET," + std::to_string(m.number), m.lengths);
    }
    std::string operator()(const Stop&) const { return "STOP"; }
    std::string operator()(const Clear&) const { return "CLEAR"; }
    std::string operator()(const Ident& m) const {
        return "IDENT,1," + m.name + ",6," + std::to_string(m.period.count()) + ',' +
               formatWireDecimal(mmFromMetres(m.minLength)) + ',' +
               formatWireDecimal(mmFromMetres(m.maxLength));
    }
    std::string operator()(const Len& m) const {
        std::string text =
            withLengths("LEN," + std::to_string(m.number) + ',' + std::to_string(m.time.count()), m.lengths);
        text += ',';
        text += toLetter(m.state);
        return text + ',' + std::to_string(m.setNumber);
    }
    std::string operator()(const Ok& m) const { return "OK," + m.request; }
    std::string operator()(const Err& m) const { return "ERR," + m.request + ',' + m.code + ',' + m.text; }
    std::string operator()(const Fault& m) const { return "FAULT," + m.code + ',' + m.text; }
    std::string operator()(const UnsupportedIdent&) const { return {}; }
    std::string operator()(const PlainLengths&) const { return {}; }
    std::string operator()(const Malformed&) const { return {}; }
};

} // namespace

std::string payloadOf(const LineMessage& message) {
    return std::visit(Formatter{}, message);
}

} // namespace hexapose::line
