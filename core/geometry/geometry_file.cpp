// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/geometry/geometry_file.h"

#include "core/geometry/input_error.h"
#include "core/geometry/number_text.h"
#include "core/geometry/text_file.h"
#include "core/geometry/units.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace hexapose {

namespace {

constexpr std::int64_t kFormat = 1;

std::string typeName(const toml::node& node) {
    switch (node.type()) {
    case toml::node_type::string:
        return "text";
    case toml::node_type::integer:
        return "an integer";
    case toml::node_type::floating_point:
        return "a decimal number";
    case toml::node_type::boolean:
        return "true or false";
    case toml::node_type::array:
        return "a list";
    case toml::node_type::table:
        return "a table";
    default:
        return "a date or time";
    }
}

/// Walks one document; every complaint carries the line it is about.
class Reader {
public:
    Reader(const toml::table& root, const std::string& source) : m_root(root), m_source(source) {}

    PlatformGeometry read() const;

private:
    [[noreturn]] void fail(const toml::node& where, const std::string& cause) const {
        throw InputError(m_source, std::max<long>(1, static_cast<long>(where.source().begin.line)), cause);
    }
    void refuseUnknown(const toml::table& table, const std::string& what,
                       std::initializer_list<std::string_view> known) const;
    const toml::node& need(const toml::table& table, const std::string& what, std::string_view key) const;
    double number(const toml::node& node, const std::string& what) const;
    Eigen::Vector3d point(const toml::table& table, const std::string& what, std::string_view key) const;
    std::string text(const toml::table& table, std::string_view key) const;
    Leg leg(const toml::node& node, int number) const;
    void judge(const PlatformGeometry& geometry, const toml::array& legs) const;

    const toml::table& m_root;
    const std::string& m_source;
};

void Reader::refuseUnknown(const toml::table& table, const std::string& what,
                           std::initializer_list<std::string_view> known) const {
    const toml::node* first = nullptr;
    std::string name;
    for (const auto& [key, node] : table) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end())
            continue;
        if (first == nullptr || node.source().begin.line < first->source().begin.line) {
            first = &node;
            name = key.str();
        }
    }
    if (first != nullptr)
        fail(*first, what + "unknown key \"" + name + "\"");
}

const toml::node& Reader::need(const toml::table& table, const std::string& what,
                               std::string_view key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr)
        fail(table, what + "missing key \"" + std::string(key) + "\"");
    return *node;
}

double Reader::number(const toml::node& node, const std::string& what) const {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value)
        fail(node, what + " is " + typeName(node) + ", not a number");
    if (!std::isfinite(*value))
        fail(node, what + " is " + formatNumber(*value) + ", not a finite number");
    return *value;
}

Eigen::Vector3d Reader::point(const toml::table& table, const std::string& what, std::string_view key) const {
    const toml::node& node = need(table, what, key);
    const std::string name = what + std::string(key);
    const toml::array* list = node.as_array();
    if (list == nullptr)
        fail(node, name + " is " + typeName(node) + ", not a list of three numbers");
    if (list->size() != 3)
        fail(node, name + " has " + std::to_string(list->size()) + " numbers, expected 3");
    Eigen::Vector3d metres;
    for (std::size_t k = 0; k < 3; ++k)
        metres[static_cast<Eigen::Index>(k)] =
            metresFromMm(number(*list->get(k), name + "[" + std::to_string(k) + "]"));
    return metres;
}

std::string Reader::text(const toml::table& table, std::string_view key) const {
    const toml::node& node = need(table, "", key);
    const auto value = node.is_string() ? node.value<std::string>() : std::nullopt;
    if (!value)
        fail(node, std::string(key) + " is " + typeName(node) + ", not text");
    if (std::any_of(value->begin(), value->end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
        fail(node, std::string(key) + " holds a line break or another control character");
    return *value;
}

Leg Reader::leg(const toml::node& node, int number) const {
    const std::string what = "leg " + std::to_string(number) + ": ";
    const toml::table* table = node.as_table();
    if (table == nullptr)
        fail(node, what + "is " + typeName(node) + ", not a table");
    refuseUnknown(*table, what, {"base_mm", "platform_mm", "min_mm", "max_mm"});
    Leg leg;
    leg.p_OA_B = point(*table, what, "base_mm");
    leg.p_PB_P = point(*table, what, "platform_mm");
    leg.minLength = metresFromMm(this->number(need(*table, what, "min_mm"), what + "min_mm"));
    leg.maxLength = metresFromMm(this->number(need(*table, what, "max_mm"), what + "max_mm"));
    return leg;
}

PlatformGeometry Reader::read() const {
    const toml::node& format = need(m_root, "", "format");
    if (!format.is_integer())
        fail(format, "format is " + typeName(format) + ", not an integer");
    if (const auto number = format.value<std::int64_t>(); number != kFormat)
        fail(format, "unknown format " + std::to_string(number.value_or(0)) + ", expected " +
                         std::to_string(kFormat));
    refuseUnknown(m_root, "", {"format", "name", "home", "leg"});

    PlatformGeometry geometry;
    geometry.name = text(m_root, "name");
    const toml::node& home = need(m_root, "", "home");
    if (!home.is_table())
        fail(home, "home is " + typeName(home) + ", not a table");
    refuseUnknown(*home.as_table(), "home: ", {"position_mm"});
    geometry.p_OP_home_B = point(*home.as_table(), "home: ", "position_mm");

    const toml::node& legs = need(m_root, "", "leg");
    const toml::array* list = legs.as_array();
    if (list == nullptr)
        fail(legs, "leg is " + typeName(legs) + ", not six [[leg]] tables");
    if (list->size() != kLegCount)
        fail(list->empty() ? legs : *list->get(std::min<std::size_t>(list->size() - 1, kLegCount)),
             "expected 6 legs, found " + std::to_string(list->size()));
    for (std::size_t i = 0; i < kLegCount; ++i)
        geometry.legs[i] = leg(*list->get(i), static_cast<int>(i) + 1);
    judge(geometry, *list);
    return geometry;
}

void Reader::judge(const PlatformGeometry& geometry, const toml::array& legs) const {
    const auto faults = findFaults(geometry);
    if (faults.empty())
        return;
    const GeometryFault& fault = faults.front();
    const toml::node* where =
        fault.leg == 0 ? m_root.get("home") : legs.get(static_cast<std::size_t>(fault.leg - 1));
    const toml::table* table = where != nullptr ? where->as_table() : nullptr;
    if (table != nullptr && table->get(fault.key) != nullptr)
        where = table->get(fault.key);
    fail(where != nullptr ? *where : m_root, fault.text);
}

/// toml++ explains over several lines at times; a message here is one.
std::string oneLine(std::string_view text) {
    std::string line(text);
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20; }, ' ');
    return line;
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += '\\';
        result += c;
    }
    return result + '"';
}

/// The millimetres that metresFromMm() turns into exactly these metres. A plain product can miss by one
/// rounding. (Metres that no double of millimetres gives, which no file can hold, come out as the nearest.)
double exactMm(double metres) {
    const double plain = mmFromMetres(metres);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double candidate :
         {plain, std::nextafter(plain, kInfinity), std::nextafter(plain, -kInfinity)})
        if (metresFromMm(candidate) == metres)
            return candidate;
    return plain;
}

std::string formatPoint(const Eigen::Vector3d& metres) {
    return '[' + formatTomlNumber(exactMm(metres[0])) + ", " + formatTomlNumber(exactMm(metres[1])) + ", " +
           formatTomlNumber(exactMm(metres[2])) + ']';
}

} // namespace

PlatformGeometry loadPlatform(const std::filesystem::path& file) {
    return parsePlatform(readTextFile(file), file.string());
}

PlatformGeometry parsePlatform(std::string_view toml, const std::string& sourceName) {
    try {
        const toml::table root = toml::parse(toml);
        return Reader(root, sourceName).read();
    } catch (const toml::parse_error& error) {
        throw InputError(sourceName, std::max<long>(1, static_cast<long>(error.source().begin.line)),
                         oneLine(error.description()));
    }
}

std::string formatPlatform(const PlatformGeometry& geometry) {
    std::string text = "format = " + std::to_string(kFormat) + "\nname = " + quoted(geometry.name) +
                       "\n\n[home]\nposition_mm = " + formatPoint(geometry.p_OP_home_B) + '\n';
    for (const Leg& leg : geometry.legs)
        text += "\n[[leg]]\nbase_mm = " + formatPoint(leg.p_OA_B) +
                "\nplatform_mm = " + formatPoint(leg.p_PB_P) +
                "\nmin_mm = " + formatTomlNumber(exactMm(leg.minLength)) +
                "\nmax_mm = " + formatTomlNumber(exactMm(leg.maxLength)) + '\n';
    return text;
}

} // namespace hexapose
