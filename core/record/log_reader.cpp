// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/log_reader.h"

#include "core/base/csv_reader.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/base/utc_text.h"
#include "core/record/event_codec.h"
#include "core/record/log_metadata.h"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace hexapose {

namespace {

constexpr std::size_t kFullWarnings = 100;
using SixColumns = std::array<std::size_t, 6>;

/// A row that cannot be read; the text is the cause.
struct BadRow {
    std::string cause;
};

/// Knows where the columns of one file are.
class RowParser {
public:
    explicit RowParser(const CsvReader& reader);
    /// Throws BadRow.
    Snapshot parse(const CsvTable::Row& row) const;

private:
    std::optional<SixColumns> findSix(const std::array<const char*, 6>& names) const;
    std::optional<PoseVector> six(const CsvTable::Row& row, const SixColumns& columns) const;
    std::optional<LegLengths> lengths(const CsvTable::Row& row,
                                      const std::optional<SixColumns>& columns) const;
    std::optional<Pose> pose(const CsvTable::Row& row, const std::optional<SixColumns>& columns) const;
    double number(const CsvTable::Row& row, std::size_t column) const;
    std::string_view text(const CsvTable::Row& row, std::optional<std::size_t> column) const;
    void parseSolution(const CsvTable::Row& row, Snapshot& snapshot) const;

    const std::vector<std::string>& m_header;
    std::size_t m_time;
    SixColumns m_lengths{};
    std::optional<SixColumns> m_commanded, m_goal, m_measured;
    std::optional<std::size_t> m_iso, m_status, m_iterations, m_residual, m_state, m_age, m_event;
};

RowParser::RowParser(const CsvReader& reader)
    : m_header(reader.header()), m_time(requireCsvColumn(m_header, "time_s", reader.sourceName())) {
    for (std::size_t i = 0; i < m_lengths.size(); ++i)
        m_lengths[i] = requireCsvColumn(m_header, "l" + std::to_string(i + 1) + "_mm", reader.sourceName());
    m_commanded = findSix({"l1_set_mm", "l2_set_mm", "l3_set_mm", "l4_set_mm", "l5_set_mm", "l6_set_mm"});
    m_goal = findSix({"x_target_mm", "y_target_mm", "z_target_mm", "alpha_target_deg", "beta_target_deg",
                      "gamma_target_deg"});
    m_measured = findSix({"x_mm", "y_mm", "z_mm", "alpha_deg", "beta_deg", "gamma_deg"});
    m_iso = findCsvColumn(m_header, "time_iso");
    m_status = findCsvColumn(m_header, "status");
    m_iterations = findCsvColumn(m_header, "iterations");
    m_residual = findCsvColumn(m_header, "residual_mm");
    m_state = findCsvColumn(m_header, "state");
    m_age = findCsvColumn(m_header, "age_ms");
    m_event = findCsvColumn(m_header, "event");
}

std::optional<SixColumns> RowParser::findSix(const std::array<const char*, 6>& names) const {
    SixColumns columns{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::optional<std::size_t> column = findCsvColumn(m_header, names[i]);
        if (!column)
            return std::nullopt;
        columns[i] = *column;
    }
    return columns;
}

double RowParser::number(const CsvTable::Row& row, std::size_t column) const {
    const std::string_view field = CsvTable::field(row, column);
    const std::optional<double> value = parseNumber(field);
    if (!value || !std::isfinite(*value))
        throw BadRow{m_header[column] + " \"" + std::string(field) + "\" is not a finite number"};
    return *value;
}

/// All six, or none when all six fields are empty.
std::optional<PoseVector> RowParser::six(const CsvTable::Row& row, const SixColumns& columns) const {
    bool empty = true;
    for (const std::size_t column : columns)
        empty = empty && CsvTable::field(row, column).empty();
    if (empty)
        return std::nullopt;
    PoseVector values;
    for (std::size_t i = 0; i < columns.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = number(row, columns[i]);
    return values;
}

std::optional<LegLengths> RowParser::lengths(const CsvTable::Row& row,
                                             const std::optional<SixColumns>& columns) const {
    const std::optional<PoseVector> mm = columns ? six(row, *columns) : std::nullopt;
    if (!mm)
        return std::nullopt;
    return mm->unaryExpr(&metresFromMm);
}

std::optional<Pose> RowParser::pose(const CsvTable::Row& row,
                                    const std::optional<SixColumns>& columns) const {
    std::optional<PoseVector> values = columns ? six(row, *columns) : std::nullopt;
    if (!values)
        return std::nullopt;
    values->head<3>() = values->head<3>().unaryExpr(&metresFromMm).eval();
    values->tail<3>() = values->tail<3>().unaryExpr(&radiansFromDeg).eval();
    return Pose::fromVector(*values);
}

std::string_view RowParser::text(const CsvTable::Row& row, std::optional<std::size_t> column) const {
    return column ? CsvTable::field(row, *column) : std::string_view();
}

void RowParser::parseSolution(const CsvTable::Row& row, Snapshot& snapshot) const {
    if (const std::string_view word = text(row, m_status); !word.empty()) {
        const std::optional<SolveStatus> status = solveStatusFromWord(word);
        if (!status)
            throw BadRow{"status \"" + std::string(word) + "\" is not known"};
        snapshot.status = *status;
    }
    if (!text(row, m_iterations).empty()) {
        const std::optional<long long> count = parseInteger(text(row, m_iterations));
        if (!count || *count < 0 || *count > std::numeric_limits<int>::max())
            throw BadRow{"iterations is not a count"};
        snapshot.iterations = static_cast<int>(*count);
    }
    if (!text(row, m_residual).empty())
        snapshot.residual = metresFromMm(number(row, *m_residual));
}

Snapshot RowParser::parse(const CsvTable::Row& row) const {
    using std::chrono::nanoseconds;
    if (row.fields.size() != m_header.size())
        throw BadRow{std::to_string(row.fields.size()) + " fields, but the header has " +
                     std::to_string(m_header.size())};
    constexpr double kMaxSeconds = 9e9; // what fits into nanoseconds of 64 bits
    const double seconds = number(row, m_time);
    if (std::abs(seconds) > kMaxSeconds)
        throw BadRow{"time_s is out of range"};

    Snapshot snapshot;
    snapshot.time = nanoseconds(std::llround(seconds * 1e9));
    snapshot.wallTime = parseUtc(text(row, m_iso)).value_or(std::chrono::system_clock::time_point{});
    snapshot.measuredLengths = lengths(row, m_lengths);
    snapshot.fresh = snapshot.measuredLengths.has_value();
    snapshot.stale = !snapshot.fresh;
    snapshot.commandedLengths = lengths(row, m_commanded);
    snapshot.goalPose = pose(row, m_goal);
    snapshot.measuredPose = pose(row, m_measured);
    parseSolution(row, snapshot);
    if (const std::string_view word = text(row, m_state); !word.empty()) {
        const std::optional<RunState> state = runStateFromWord(word);
        if (!state)
            throw BadRow{"state \"" + std::string(word) + "\" is not known"};
        snapshot.state = *state;
    }
    if (const std::optional<double> age = parseNumber(text(row, m_age)); age && std::abs(*age) < kMaxSeconds)
        snapshot.age = nanoseconds(std::llround(*age * 1e6));
    snapshot.events = parseEvents(text(row, m_event));
    return snapshot;
}

void readMetadata(const std::filesystem::path& csvFile, SessionLog& log) {
    const std::filesystem::path file = logMetadataFile(csvFile);
    std::error_code ignored;
    if (csvFile == "-" || file == csvFile || !std::filesystem::exists(file, ignored))
        return;
    RecordedMetadata metadata = readLogMetadata(file);
    log.platform = std::move(metadata.platform);
    log.platformFingerprint = std::move(metadata.platformFingerprint);
    log.modelFingerprint = std::move(metadata.modelFingerprint);
    log.solver = std::move(metadata.solver);
    log.programVersion = std::move(metadata.programVersion);
    if (!log.platform)
        log.warnings.push_back(file.string() + ": holds no [platform]");
}

} // namespace

SessionLog readSessionLog(const std::filesystem::path& csvFile) {
    CsvSource source(csvFile);
    CsvReader reader(source.stream(), source.name());
    SessionLog log;
    readMetadata(csvFile, log);
    const RowParser parser(reader);
    std::size_t leftOut = 0;
    for (CsvTable::Row row; reader.next(row);) {
        try {
            log.rows.push_back(parser.parse(row));
        } catch (const BadRow& bad) {
            if (++leftOut <= kFullWarnings)
                log.warnings.push_back(source.name() + ":" + std::to_string(row.line) +
                                       ": row left out: " + bad.cause);
        }
    }
    if (leftOut > kFullWarnings)
        log.warnings.push_back(source.name() + ": " + std::to_string(leftOut - kFullWarnings) +
                               " more rows left out");
    if (reader.halfWritten())
        log.warnings.push_back(reader.halfWrittenWarning());
    return log;
}

} // namespace hexapose
