// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/cli/interrupt.h"
#include "app/cli/solver_choice.h"
#include "app/common/arguments.h"
#include "app/common/device_factory.h"
#include "app/common/platform_check.h"
#include "app/common/port_check.h"
#include "app/common/visit_words.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/machine/control_options.h"
#include "core/record/event_codec.h"
#include "core/record/log_metadata.h"
#include "core/record/motion_check_words.h"
#include "core/record/pose_list.h"
#include "core/report/error_report.h"
#include "core/session/visit_job.h"
#include "ui/report/report_export.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace hexapose {

namespace {

/// Before anything moves: a pose that cannot be reached makes the whole list unusable.
void requireReachable(const MotionPlanner& planner, const std::vector<Pose>& targets,
                      const std::string& file) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const MotionCheck check = planner.check(targets[i]);
        if (check.ok())
            continue;
        std::string cause = "attitude " + std::to_string(i + 1) + ": " + toWords(check);
        if (check.axis > 3)
            cause += " (" + formatFixed(degFromRadians(check.value), 3) + " against " +
                     formatNumber(degFromRadians(check.bound)) + " deg)";
        else if (check.leg > 0 || check.axis > 0)
            cause += " (" + formatFixed(mmFromMetres(check.value), 3) + " against " +
                     formatNumber(mmFromMetres(check.bound)) + " mm)";
        throw InputError(file, cause);
    }
}

namespace fs = std::filesystem;

/// What the report and the log are for each other is found out before either is made.
void checkReport(const std::string& directory, const std::string& logFile) {
    const fs::path report = fs::absolute(directory).lexically_normal();
    const fs::path log = fs::absolute(logFile).lexically_normal();
    if (report / "" == log / "" || report / "" == logMetadataFile(log) / "")
        throw InputError("--report", "'" + directory + "' is where the log goes");
}

/// The directory of the report, made now rather than after the run, when there is nothing left but to say
/// that the report is lost; and unmade when the run does not come about.
class ReportDirectory {
public:
    explicit ReportDirectory(const std::string& directory) {
        std::error_code error;
        fs::path missing = fs::absolute(directory).lexically_normal();
        for (; !missing.empty() && !fs::exists(missing, error) && missing != missing.parent_path();
             missing = missing.parent_path())
            m_made.push_back(missing);
        fs::create_directories(directory, error);
        if (error)
            undo();
        if (error)
            throw InputError(directory, "cannot be made: " + error.message());
        if (access(directory.c_str(), W_OK | X_OK) != 0)
            throw InputError(directory, "cannot be written: " + std::generic_category().message(errno));
    }
    ~ReportDirectory() { undo(); }
    ReportDirectory(const ReportDirectory&) = delete;
    ReportDirectory& operator=(const ReportDirectory&) = delete;
    void keep() { m_made.clear(); }

private:
    void undo() {
        std::error_code ignored;
        for (const fs::path& path : m_made)
            fs::remove(path, ignored); // an empty one only
    }
    std::vector<fs::path> m_made; ///< the innermost first
};

ConnectionSpec connectionOf(const std::string& port, int baud) {
    if (port == "virtual")
        return VirtualConnection{};
    requireSerialPort(port);
    return SerialConnection{port, baud};
}

/// What follows from an end of this kind.
std::string remedyOf(const VisitFailure& failure) {
    const bool refused = failure.event && failure.event->code == EventCode::CommandRefused;
    return refused && isDown(failure.state) ? "; --clear leaves it first" : "";
}

/// "z,5,0.1,2,20": 5 mm along z, from 0.1 to 2 Hz in 20 s.
std::optional<SweepSettings> sweepOf(const Arguments& arguments) {
    if (!arguments.has("sweep"))
        return std::nullopt;
    if (arguments.has("targets"))
        throw InputError("--sweep", "cannot be used together with --targets");
    const std::string text = arguments.requiredText("sweep");
    const QStringList words = QString::fromStdString(text).split(QLatin1Char(','));
    const QStringList axes{QStringLiteral("x"),     QStringLiteral("y"),    QStringLiteral("z"),
                           QStringLiteral("alpha"), QStringLiteral("beta"), QStringLiteral("gamma")};
    SweepSettings sweep;
    if (words.size() != 5)
        throw InputError("--sweep", "'" + text + "' has " + std::to_string(words.size()) +
                                        " fields, expected AXIS,AMPLITUDE,HZ,HZ,SECONDS");
    sweep.axis = static_cast<int>(axes.indexOf(words[0]));
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < numbers.size() && sweep.axis >= 0; ++i)
        numbers[i] = parseNumber(words[static_cast<qsizetype>(i) + 1].toStdString()).value_or(std::nan(""));
    sweep.amplitude = sweep.axis < 3 ? metresFromMm(numbers[0]) : radiansFromDeg(numbers[0]);
    sweep.startFrequency = numbers[1];
    sweep.endFrequency = numbers[2];
    sweep.seconds = numbers[3];
    if (const auto fault = faultOf(sweep))
        throw InputError("--sweep", "'" + text + "': " + std::string(toWords(*fault)) +
                                        " (expected AXIS,AMPLITUDE,HZ,HZ,SECONDS)");
    return sweep;
}

} // namespace

Usage runUsage() {
    return {
        "hexapose-cli run",
        {},
        withSolverOptions(
            {{"port", "PATH|virtual", "Serial port, or the built-in virtual platform."},
             {"baud", "N", "Baud rate (default: 115200)."},
             {"targets", "POSES.csv", "Poses to visit, in order."},
             {"sweep", "AXIS,A,F0,F1,T",
              "In place of targets: a sine about the present pose, of A mm or deg, from F0 to F1 Hz in T "
              "s."},
             {"mode", "joint|workspace", "Leg by leg, or closed on the pose (default: joint)."},
             {"speed", "PERCENT", "Speed override, in percent of full speed (default: 100)."},
             {"envelope-mm", "E",
              "Refuse moves further than E mm from home along x, y or z (default: no limit)."},
             {"envelope-deg", "E",
              "Refuse moves further than E degrees in alpha, beta or gamma (default: no limit)."},
             {"log", "LOG.csv", "The log to write; never one that exists."},
             {"log-part-mb", "N", "Begin another file, LOG-2.csv, after N MB of the log (default: 1000)."},
             {"log-gzip", "", "Compress each of these files but the last: LOG.csv.gz."},
             {"report", "DIR", "Write the error report into this directory."},
             {"clear", "", "Clear a stop or fault of the controller first."}})};
}

int runCommand(const Arguments& arguments) {
    const std::string port = arguments.requiredText("port");
    const std::optional<SweepSettings> sweep = sweepOf(arguments);
    if (!sweep && !arguments.has("targets"))
        throw InputError("hexapose-cli run", "missing --targets (or --sweep)");
    const std::string targetsFile = sweep ? std::string() : arguments.requiredText("targets");
    const std::string logFile = arguments.requiredText("log");
    const std::string modeWord = arguments.text("mode", "joint");
    const std::optional<MotionMode> mode = motionModeFromWord(modeWord);
    if (!mode)
        throw InputError("--mode", "'" + modeWord + "' is not a mode (known: joint, workspace)");
    const double percent = arguments.positive("speed", 100.0);
    if (percent > 100.0)
        throw InputError("--speed", formatNumber(percent) + " is above 100");
    const int baud = arguments.baud();
    const PlatformGeometry platform = arguments.platform();
    requireMovable(platform, arguments.text("platform", "laboratory"));
    const std::vector<Pose> targets = sweep ? std::vector<Pose>{Pose{}} : readPoseList(targetsFile);
    ControlOptions control;
    control.envelope = arguments.envelope();
    const SharedModel model = makeModel(platform);
    requireReachable(MotionPlanner(model, plannerSettings(control, platform)), targets, targetsFile);
    const ChosenSolver chosen = chooseSolver(arguments, platform);
    if (arguments.has("report"))
        checkReport(arguments.requiredText("report"), logFile);
    if (logFile == "-")
        throw InputError("--log", "'-' is no file: a log is written to one that stays");
    std::optional<ReportDirectory> reportDirectory;
    if (arguments.has("report"))
        reportDirectory.emplace(arguments.requiredText("report"));
    const ConnectionSpec connection = connectionOf(port, baud);

    SessionSetup setup;
    setup.model = model;
    setup.solver = chosen.solver;
    setup.modelFingerprint = chosen.modelFingerprint;
    setup.programVersion = HEXAPOSE_VERSION;
    setup.control = control;
    setup.log = arguments.logOptions();
    catchInterrupts(); // before the loop's thread can enable anything
    Session session(setup, [&platform](const ConnectionSpec& where) { return makeDevice(where, platform); });
    session.open(connection, logFile);
    if (reportDirectory)
        reportDirectory->keep();
    VisitJob::Options options;
    options.mode = *mode;
    options.speedOverride = percent / 100.0;
    options.sweep = sweep;
    options.clearFirst = arguments.has("clear");
    VisitJob job(targets, options);
    runToTheEnd(job, session, interrupted);

    const ErrorReport report = makeErrorReport(platform, *chosen.solver, job.samples());
    const std::string table = formatErrorCsv(report);
    std::fwrite(table.data(), 1, table.size(), stdout);
    if (arguments.has("report") && !job.samples().empty())
        exportErrorReport(report, arguments.requiredText("report"));
    const std::optional<LogFailure> logFailure = session.logFailure();
    if (logFailure)
        std::fprintf(stderr, "hexapose-cli: %s: %s\n", logFile.c_str(),
                     payloadWords({EventCode::LogFailed, *logFailure}).c_str());
    std::string failure = failureWords(job);
    if (job.failure())
        failure += remedyOf(*job.failure());
    if (!failure.empty())
        std::fprintf(stderr, "hexapose-cli: %s: visited %zu of %zu attitudes: %s\n", port.c_str(),
                     job.visited(), job.count(), failure.c_str());
    return !failure.empty() || logFailure || report.failed > 0 ? kExitSomeFailed : kExitDone;
}

} // namespace hexapose
