// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/mechanism_file.h"

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text_file.h"
#include "core/base/toml_values.h"
#include "core/base/units.h"
#include "core/finite_step/mechanism_checks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace hexapose {

namespace {

constexpr std::int64_t kFormat = 1;
constexpr double kMostMm = 1e9;

using Keys = std::initializer_list<std::string_view>;

/// What a mechanism's file has besides.
class Values : public TomlValues {
public:
    using TomlValues::TomlValues;

    double number(const toml::node& node, const std::string& name) const {
        const double value = TomlValues::number(node, name);
        if (std::abs(value) > kMostMm)
            fail(node, name + " is " + formatNumber(value) + ", not a number of ordinary size");
        return value;
    }
    Eigen::Vector3d vector(const toml::table& table, const std::string& what, std::string_view key) const {
        const Eigen::Vector3d values = TomlValues::vector(table, what, key);
        for (std::size_t k = 0; k < 3; ++k)
            number(*table.get(key)->as_array()->get(k),
                   what + std::string(key) + "[" + std::to_string(k) + "]");
        return values;
    }
    Eigen::Vector3d point(const toml::table& table, const std::string& what, std::string_view key) const {
        return vector(table, what, key).unaryExpr(&metresFromMm);
    }
    Eigen::Vector3d unit(const toml::table& table, const std::string& what, std::string_view key) const {
        const Eigen::Vector3d direction = vector(table, what, key);
        if (!(direction.norm() > 0.0))
            fail(need(table, what, key), what + std::string(key) + " has no direction");
        return direction.normalized();
    }
    /// A name goes into messages and columns.
    std::string name(const toml::table& table, const std::string& what) const {
        const toml::node& node = need(table, what, "name");
        const std::string value = text(node, what + "name");
        const auto isPlain = [](unsigned char c) {
            return std::isalnum(c) != 0 ||
                   std::string_view("_'.+-").find(static_cast<char>(c)) != std::string_view::npos;
        };
        if (value.empty())
            fail(node, what + "name is empty");
        if (!std::all_of(value.begin(), value.end(), isPlain))
            fail(node, what + "name \"" + value + "\" has other characters than letters, digits and _'.+-");
        return value;
    }
};

/// Walks one document.
class Reader {
public:
    Reader(const toml::table& root, const std::string& source) : m_root(root), m_values(source) {}
    Mechanism read();

private:
    template <class Read>
    void each(std::string_view key, const Read& read) const;
    std::size_t find(const toml::node& node, const std::string& what) const;
    std::vector<std::size_t> findAll(const toml::table& table, const std::string& what,
                                     std::size_t count) const;
    std::string kind(const toml::table& table, const std::string& what, Keys known) const;
    void addPoint(const toml::table& table, const std::string& what, bool isNode);
    void setCarriers(const toml::table& table, const std::string& what, MechanismPoint& point) const;
    void addActuator(const toml::table& table, const std::string& what);
    void readHand(const toml::table& table, const std::string& what, Actuator& actuator) const;
    void readReference(const toml::table& table, const std::string& what, Actuator& actuator) const;
    void addRigid(const toml::table& table, const std::string& what);
    void addProjection(const toml::table& table, const std::string& what);
    void addSpecial(const toml::table& table, const std::string& what);
    void readOutput(const toml::table& output);
    void readPivot(const toml::table& output);
    void require(const toml::node& where, const std::string& what, const std::string& fault) const {
        if (!fault.empty())
            m_values.fail(where, what + fault);
    }

    const toml::table& m_root;
    Values m_values;
    Mechanism m_mechanism;
};

/// Every table of an array of tables, with "node 3: " for messages.
template <class Read>
void Reader::each(std::string_view key, const Read& read) const {
    const toml::node* node = m_root.get(key);
    if (node == nullptr)
        return;
    const toml::array* list = node->as_array();
    if (list == nullptr || !list->is_array_of_tables())
        m_values.fail(*node, std::string(key) + " is not a list of [[" + std::string(key) + "]] tables");
    int number = 0;
    for (const toml::node& entry : *list)
        read(*entry.as_table(), std::string(key) + " " + std::to_string(++number) + ": ");
}

std::size_t Reader::find(const toml::node& node, const std::string& what) const {
    const std::string name = m_values.text(node, what);
    const auto& points = m_mechanism.points;
    const auto found =
        std::find_if(points.begin(), points.end(), [&](const auto& point) { return point.name == name; });
    if (found == points.end())
        m_values.fail(node, what + ": no point is called \"" + name + "\"");
    return static_cast<std::size_t>(found - points.begin());
}

std::vector<std::size_t> Reader::findAll(const toml::table& table, const std::string& what,
                                         std::size_t count) const {
    const toml::node& node = m_values.need(table, what, "points");
    const toml::array* list = node.as_array();
    if (list == nullptr || list->size() != count)
        m_values.fail(node, what + "points is not a list of " + std::to_string(count) + " names");
    std::vector<std::size_t> found;
    for (const toml::node& entry : *list) {
        found.push_back(find(entry, what + "points"));
        if (std::count(found.begin(), found.end(), found.back()) > 1)
            m_values.fail(entry, what + "points names one twice");
    }
    return found;
}

std::string Reader::kind(const toml::table& table, const std::string& what, Keys known) const {
    const toml::node& node = m_values.need(table, what, "kind");
    const std::string word = m_values.text(node, what + "kind");
    std::string words;
    for (const std::string_view one : known) {
        if (one == word)
            return word;
        words += (words.empty() ? "" : ", ") + std::string(one);
    }
    m_values.fail(node, what + "unknown kind \"" + word + "\" (known: " + words + ")");
}

void Reader::addPoint(const toml::table& table, const std::string& what, bool isNode) {
    if (isNode)
        m_values.refuseUnknown(table, what, {"name", "home_mm", "carried_by"});
    else
        m_values.refuseUnknown(table, what, {"name", "position_mm"});
    MechanismPoint point;
    point.name = m_values.name(table, what);
    for (const MechanismPoint& other : m_mechanism.points)
        if (other.name == point.name)
            m_values.fail(*table.get("name"), what + "another point is called \"" + point.name + "\"");
    point.home_B = m_values.point(table, what, isNode ? "home_mm" : "position_mm");
    point.kind = !isNode                        ? PointKind::Fixed
                 : table.contains("carried_by") ? PointKind::Carried
                                                : PointKind::Node;
    m_mechanism.points.push_back(point);
}

/// After all points are known.
void Reader::setCarriers(const toml::table& table, const std::string& what, MechanismPoint& point) const {
    const toml::node& node = *table.get("carried_by");
    const toml::array* list = node.as_array();
    if (list == nullptr || list->size() < 3 || list->size() > 4)
        m_values.fail(node, what + "carried_by is not a list of three or four names");
    for (const toml::node& entry : *list)
        point.carriers.push_back(find(entry, what + "carried_by"));
    require(node, what, carriageFault(m_mechanism, point));
}

void Reader::readReference(const toml::table& table, const std::string& what, Actuator& actuator) const {
    const toml::node* node = table.get("reference");
    if (node == nullptr)
        return;
    const toml::table* reference = node->as_table();
    if (reference == nullptr)
        m_values.fail(*node, what + "reference is " + tomlTypeName(*node) + ", not a table");
    const bool isCrank = actuator.kind == ActuatorKind::Crank;
    const std::string_view key = isCrank ? "amplitude_deg" : "amplitude_mm";
    m_values.refuseUnknown(*reference, what + "reference: ", {key, "rate_deg_per_s"});
    const auto read = [&](std::string_view name) {
        return m_values.number(m_values.need(*reference, what + "reference: ", name),
                               what + "reference: " + std::string(name));
    };
    const double amplitude = read(key);
    actuator.referenceAmplitude = isCrank ? radiansFromDeg(amplitude) : metresFromMm(amplitude);
    actuator.referenceRate = radiansFromDeg(read("rate_deg_per_s"));
}

void Reader::readHand(const toml::table& table, const std::string& what, Actuator& actuator) const {
    if (actuator.kind == ActuatorKind::Slider) {
        m_values.refuseUnknown(table, what, {"name", "kind", "node", "slider_mm", "direction", "reference"});
        actuator.hand_B = m_values.point(table, what, "slider_mm");
        actuator.axis_B = m_values.unit(table, what, "direction");
    } else {
        m_values.refuseUnknown(table, what,
                               {"name", "kind", "node", "centre_mm", "axis", "crank_mm", "reference"});
        actuator.centre_B = m_values.point(table, what, "centre_mm");
        actuator.hand_B = m_values.point(table, what, "crank_mm");
        actuator.axis_B = m_values.unit(table, what, "axis");
    }
}

void Reader::addActuator(const toml::table& table, const std::string& what) {
    Actuator actuator;
    actuator.name = m_values.name(table, what);
    for (const Actuator& other : m_mechanism.actuators)
        if (other.name == actuator.name)
            m_values.fail(*table.get("name"), what + "another actuator is called \"" + actuator.name + "\"");
    const std::string word = kind(table, what, {"ups", "pus", "rus"});
    actuator.kind = word == "ups"   ? ActuatorKind::Leg
                    : word == "pus" ? ActuatorKind::Slider
                                    : ActuatorKind::Crank;
    actuator.node = find(m_values.need(table, what, "node"), what + "node");
    if (actuator.kind == ActuatorKind::Leg) {
        m_values.refuseUnknown(table, what, {"name", "kind", "base", "node", "reference"});
        actuator.base = find(m_values.need(table, what, "base"), what + "base");
    } else {
        readHand(table, what, actuator);
    }
    require(table, what, actuatorFault(m_mechanism, actuator));
    readReference(table, what, actuator);
    m_mechanism.actuators.push_back(actuator);
}

void Reader::addRigid(const toml::table& table, const std::string& what) {
    m_values.refuseUnknown(table, what, {"kind", "points"});
    Constraint constraint;
    constraint.kind = kind(table, what, {"distance", "translation"}) == "distance"
                          ? ConstraintKind::Distance
                          : ConstraintKind::Translation;
    constraint.points = findAll(table, what, 2);
    require(table, what, constraintFault(m_mechanism, constraint));
    m_mechanism.constraints.push_back(constraint);
}

void Reader::addProjection(const toml::table& table, const std::string& what) {
    m_values.refuseUnknown(table, what, {"points", "centre"});
    Constraint constraint;
    constraint.kind = ConstraintKind::Projection;
    constraint.points = findAll(table, what, 2);
    constraint.points.push_back(find(m_values.need(table, what, "centre"), what + "centre"));
    m_mechanism.constraints.push_back(constraint);
}

void Reader::addSpecial(const toml::table& table, const std::string& what) {
    Constraint constraint;
    if (kind(table, what, {"circle", "plane"}) == "plane") {
        m_values.refuseUnknown(table, what, {"kind", "point", "normal"});
        constraint.kind = ConstraintKind::Plane;
        constraint.points = {find(m_values.need(table, what, "point"), what + "point")};
        constraint.normal_B = m_values.unit(table, what, "normal");
    } else {
        m_values.refuseUnknown(table, what, {"kind", "points", "centre"});
        constraint.kind = ConstraintKind::Circle;
        constraint.points = findAll(table, what, 3);
        constraint.points.push_back(find(m_values.need(table, what, "centre"), what + "centre"));
    }
    require(table, what, constraintFault(m_mechanism, constraint));
    m_mechanism.constraints.push_back(constraint);
}

void Reader::readOutput(const toml::table& output) {
    m_values.refuseUnknown(output, "output: ", {"position_mm", "turns", "pivot"});
    m_mechanism.output.p_OP_home_B = m_values.point(output, "output: ", "position_mm");
    const toml::node* turns = output.get("turns");
    if (turns == nullptr)
        return;
    if (!turns->is_boolean())
        m_values.fail(*turns, "output: turns is " + tomlTypeName(*turns) + ", not true or false");
    m_mechanism.output.turns = turns->value<bool>().value_or(true);
}

/// After all points are known.
void Reader::readPivot(const toml::table& output) {
    const toml::node* pivot = output.get("pivot");
    if (pivot == nullptr)
        return;
    const MechanismPoint& point = m_mechanism.points[find(*pivot, "output: pivot")];
    if (point.kind != PointKind::Fixed)
        m_values.fail(*pivot, "output: pivot names \"" + point.name + "\", which is not fixed");
    if (!m_mechanism.output.turns)
        m_values.fail(*pivot, "output: pivot is of no use with turns = false");
    m_mechanism.output.pivot_B = point.home_B;
}

Mechanism Reader::read() {
    m_values.needFormat(m_root, kFormat);
    m_values.refuseUnknown(
        m_root, "",
        {"format", "name", "output", "fixed", "node", "actuator", "rigid", "projection", "special"});
    m_mechanism.name = m_values.text(m_values.need(m_root, "", "name"), "name");
    m_values.need(m_root, "", "actuator");
    const toml::table& output = m_values.needTable(m_root, "", "output");
    readOutput(output);
    each("fixed", [&](const toml::table& t, const std::string& what) { addPoint(t, what, false); });
    std::size_t next = m_mechanism.points.size();
    each("node", [&](const toml::table& t, const std::string& what) { addPoint(t, what, true); });
    each("node", [&](const toml::table& t, const std::string& what) {
        MechanismPoint& point = m_mechanism.points[next++];
        if (point.kind == PointKind::Carried)
            setCarriers(t, what, point);
    });
    each("actuator", [&](const toml::table& t, const std::string& what) { addActuator(t, what); });
    each("rigid", [&](const toml::table& t, const std::string& what) { addRigid(t, what); });
    each("projection", [&](const toml::table& t, const std::string& what) { addProjection(t, what); });
    each("special", [&](const toml::table& t, const std::string& what) { addSpecial(t, what); });
    readPivot(output);
    require(output, "output: ", outputFault(m_mechanism));
    return m_mechanism;
}

} // namespace

Mechanism loadMechanism(const std::filesystem::path& file) {
    return parseMechanism(readTextFile(file), file.string());
}

Mechanism parseMechanism(std::string_view toml, const std::string& sourceName) {
    const toml::table root = parseToml(toml, sourceName);
    return Reader(root, sourceName).read();
}

} // namespace hexapose
