// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/geometry/geometry_file.h"

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text_file.h"
#include "core/base/toml_values.h"
#include "core/base/units.h"
#include "core/geometry/likely_cause.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapose {

namespace {

constexpr std::int64_t kFormat = 1;

/// Walks one document.
class Reader {
public:
    Reader(const toml::table& root, const std::string& source) : m_root(root), m_values(source) {}

    PlatformGeometry read() const;

private:
    Eigen::Vector3d point(const toml::table& table, const std::string& what, std::string_view key) const {
        return m_values.vector(table, what, key).unaryExpr(&metresFromMm);
    }
    Leg leg(const toml::node& node, int number) const;
    void validate(const PlatformGeometry& geometry, const toml::array& legs) const;

    const toml::table& m_root;
    const TomlValues m_values;
};

Leg Reader::leg(const toml::node& node, int number) const {
    const std::string what = "leg " + std::to_string(number) + ": ";
    const toml::table* table = node.as_table();
    if (table == nullptr)
        m_values.fail(node, what + "is " + tomlTypeName(node) + ", not a table");
    m_values.refuseUnknown(*table, what, {"base_mm", "platform_mm", "min_mm", "max_mm"});
    Leg leg;
    leg.p_OA_B = point(*table, what, "base_mm");
    leg.p_PB_P = point(*table, what, "platform_mm");
    leg.minLength = metresFromMm(m_values.number(m_values.need(*table, what, "min_mm"), what + "min_mm"));
    leg.maxLength = metresFromMm(m_values.number(m_values.need(*table, what, "max_mm"), what + "max_mm"));
    return leg;
}

PlatformGeometry Reader::read() const {
    m_values.needFormat(m_root, kFormat);
    m_values.refuseUnknown(m_root, "", {"format", "name", "home", "leg"});

    PlatformGeometry geometry;
    geometry.name = m_values.text(m_values.need(m_root, "", "name"), "name");
    const toml::table& home = m_values.needTable(m_root, "", "home");
    m_values.refuseUnknown(home, "home: ", {"position_mm"});
    geometry.p_OP_home_B = point(home, "home: ", "position_mm");

    const toml::node& legs = m_values.need(m_root, "", "leg");
    const toml::array* list = legs.as_array();
    if (list == nullptr)
        m_values.fail(legs, "leg is " + tomlTypeName(legs) + ", not six [[leg]] tables");
    if (list->size() != kLegCount)
        m_values.fail(list->empty() ? legs : *list->get(std::min<std::size_t>(list->size() - 1, kLegCount)),
                      "expected 6 legs, found " + std::to_string(list->size()));
    for (std::size_t i = 0; i < kLegCount; ++i)
        geometry.legs[i] = leg(*list->get(i), static_cast<int>(i) + 1);
    validate(geometry, *list);
    return geometry;
}

void Reader::validate(const PlatformGeometry& geometry, const toml::array& legs) const {
    const auto faults = findFaults(geometry);
    if (faults.empty())
        return;
    const GeometryFault& fault = faults.front();
    const toml::node* where =
        fault.leg == 0 ? m_root.get("home") : legs.get(static_cast<std::size_t>(fault.leg - 1));
    const toml::table* table = where != nullptr ? where->as_table() : nullptr;
    if (table != nullptr && table->get(fault.key) != nullptr)
        where = table->get(fault.key);
    std::string text = fault.text;
    if (const std::string mistake = likelyMistakeOfStrokes(geometry); !mistake.empty())
        text += "; likely cause: " + mistake;
    m_values.fail(where != nullptr ? *where : m_root, text);
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
    const toml::table root = parseToml(toml, sourceName);
    return Reader(root, sourceName).read();
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
