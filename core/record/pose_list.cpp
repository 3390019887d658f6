// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/pose_list.h"

#include "core/base/csv_table.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace hexapose {

std::vector<Pose> readPoseList(const std::filesystem::path& file) {
    constexpr std::array<std::string_view, 6> kNames{"x_mm",      "y_mm",     "z_mm",
                                                     "alpha_deg", "beta_deg", "gamma_deg"};
    using Kind = InputFault::Kind;
    const CsvTable table = readCsv(file);
    // Where a log may end anywhere, a list of places to go to must be whole.
    if (!table.warnings.empty())
        throw InputError(InputFault{Kind::LastLineIncomplete, table.sourceName, table.halfWritten->line});
    std::array<std::size_t, 6> columns{};
    for (std::size_t i = 0; i < columns.size(); ++i)
        columns[i] = table.requireColumn(kNames[i]);

    std::vector<Pose> poses;
    for (const CsvTable::Row& row : table.rows) {
        if (row.fields.size() != table.header.size())
            throw InputError(
                InputFault{Kind::FieldCount,
                           table.sourceName,
                           row.line,
                           {std::to_string(row.fields.size()), std::to_string(table.header.size())}});
        PoseVector values;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::string_view text = CsvTable::field(row, columns[i]);
            const std::optional<double> number = parseNumber(text);
            if (!number || !std::isfinite(*number))
                throw InputError(InputFault{Kind::NotFinite,
                                            table.sourceName,
                                            row.line,
                                            {std::string(kNames[i]), std::string(text)}});
            values[static_cast<Eigen::Index>(i)] = i < 3 ? metresFromMm(*number) : radiansFromDeg(*number);
        }
        poses.push_back(Pose::fromVector(values));
    }
    if (poses.empty())
        throw InputError(InputFault{Kind::NoPoses, table.sourceName});
    return poses;
}

} // namespace hexapose
