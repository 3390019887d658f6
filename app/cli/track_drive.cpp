// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/track_drive.h"

#include "app/cli/number_rows.h"
#include "core/base/csv_table.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace hexapose {

namespace {

constexpr double kReferenceSeconds = 2.0;

bool isCrank(const Actuator& actuator) {
    return actuator.kind == ActuatorKind::Crank;
}

std::string valueColumn(const Actuator& actuator) {
    return actuator.name + (isCrank(actuator) ? "_deg" : "_mm");
}

/// Rates are used only where every actuator has them: half of them would be an oversight.
bool hasRates(const CsvTable& table, const Mechanism& mechanism) {
    return std::any_of(mechanism.actuators.begin(), mechanism.actuators.end(), [&](const Actuator& actuator) {
        return table.findColumn(valueColumn(actuator) + "_per_s") ||
               table.findColumn(valueColumn(actuator) + "_per_s2");
    });
}

double numberOf(const CsvTable& table, const CsvTable::Row& row, std::size_t column) {
    const std::string_view text = CsvTable::field(row, column);
    const std::optional<double> number = parseNumber(text);
    if (!number || !std::isfinite(*number))
        throw InputError(table.sourceName, row.line,
                         table.header[column] + " '" + std::string(text) + "' is not a finite number");
    return *number;
}

} // namespace

std::unique_ptr<DrivePath> readDrive(const std::string& file, const Mechanism& mechanism) {
    const CsvTable table = readCsv(file);
    TableDrive::Samples samples;
    samples.withRates = hasRates(table, mechanism);
    samples.states.resize(mechanism.actuators.size());
    const std::size_t time = table.requireColumn("time_s");
    std::vector<std::array<std::size_t, 3>> columns;
    for (const Actuator& actuator : mechanism.actuators) {
        const std::string name = valueColumn(actuator);
        const std::size_t value = table.requireColumn(name);
        columns.push_back({value, value, value});
        if (samples.withRates)
            columns.back() = {value, table.requireColumn(name + "_per_s"),
                              table.requireColumn(name + "_per_s2")};
    }
    for (const CsvTable::Row& row : everyRow(table)) {
        if (row.fields.size() != table.header.size())
            throw InputError(table.sourceName, row.line,
                             std::to_string(row.fields.size()) + " fields, the header has " +
                                 std::to_string(table.header.size()));
        samples.times.push_back(numberOf(table, row, time));
        if (samples.times.size() > 1 && !(samples.times.back() > samples.times[samples.times.size() - 2]))
            throw InputError(table.sourceName, row.line, "time_s does not rise");
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const Actuator& actuator = mechanism.actuators[i];
            const auto read = [&](std::size_t column) {
                const double value = numberOf(table, row, column);
                return isCrank(actuator) ? radiansFromDeg(value) : metresFromMm(value);
            };
            DriveState state{read(columns[i][0]), 0.0, 0.0};
            if (samples.withRates)
                state = {state.value, read(columns[i][1]), read(columns[i][2])};
            if (actuator.kind == ActuatorKind::Leg && !(state.value > 0.0))
                throw InputError(table.sourceName, row.line, valueColumn(actuator) + " is not above 0");
            samples.states[i].push_back(state);
        }
    }
    if (samples.times.size() < 2)
        throw InputError(table.sourceName, "a drive has two rows or more");
    return std::make_unique<TableDrive>(std::move(samples));
}

std::unique_ptr<DrivePath> referenceDrive(const Mechanism& mechanism) {
    const bool none = std::all_of(mechanism.actuators.begin(), mechanism.actuators.end(),
                                  [](const Actuator& actuator) { return actuator.referenceRate == 0.0; });
    if (none)
        throw InputError("--drive", "\"" + mechanism.name + "\" has no reference drive");
    return std::make_unique<ReferenceDrive>(mechanism, kReferenceSeconds);
}

} // namespace hexapose
