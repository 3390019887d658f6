// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Time of one forward solution. Cold: start at home. Set 1: +-10 mm +-10 deg; set 2: +-40 mm +-40 deg. Warm:
// start 0.1 mm and 0.1 deg beside the solution, in each coordinate. All to a leg residual of 1e-10 m.
#include "core/base/units.h"
#include "core/finite_step/finite_step_solver.h"
#include "core/finite_step/leg_path.h"
#include "core/geometry/geometry_file.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/regression/mpr_newton.h"
#include "core/kinematics/regression/polynomial_training.h"
#include "fma_peak.h"
#include "planning_rows.h"
#include "ratio_report.h"
#include "tests/support/vector_unit.h"
#include "yardstick.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace hexapose;
using namespace hexapose::bench;

constexpr double kTolerance = 1e-10;
constexpr int kPoses = 4096;
/// Of one pose of a batch over set 2, by the count in core/kinematics/README.md.
constexpr double kFlopsOfBatch = 2930.0;

enum class Start { Home, Near };

struct Jobs {
    std::string name;
    std::vector<LegLengths> lengths;
    std::vector<Pose> starts;
};

const PlatformGeometry& laboratory() {
    static const PlatformGeometry geometry =
        loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
    return geometry;
}

Jobs makeJobs(const std::string& name, int set, Start start) {
    std::mt19937_64 random(7);
    const auto draw = [&random](double mm, double deg) {
        PoseVector v;
        for (int i = 0; i < 6; ++i)
            v[i] = (static_cast<double>(random() >> 11) * 0x1p-52 - 1.0) *
                   (i < 3 ? metresFromMm(mm) : radiansFromDeg(deg));
        return v;
    };
    const double range = set == 1 ? 10.0 : 40.0;
    Jobs jobs{name, {}, {}};
    for (int i = 0; i < kPoses; ++i) {
        const PoseVector truth = draw(range, range);
        jobs.lengths.push_back(legLengths(laboratory(), Pose::fromVector(truth)));
        jobs.starts.push_back(start == Start::Near ? Pose::fromVector(truth + draw(0.1, 0.1)) : Pose{});
    }
    return jobs;
}

PolynomialModel model(int degree) {
    return *trainModel(laboratory(), defaultTrainingSpec(laboratory(), degree));
}

/// Runs solveOne(lengths, start) -> iterations over the jobs, one a benchmark iteration.
template <class Solve>
void add(const Jobs& jobs, const std::string& what, Solve solveOne) {
    benchmark::RegisterBenchmark(
        (jobs.name + " / " + what).c_str(), [&jobs, solveOne](benchmark::State& state) {
            std::size_t next = 0;
            std::int64_t iterations = 0;
            for (auto _ : state) {
                iterations += solveOne(jobs.lengths[next], jobs.starts[next]);
                next = (next + 1) % kPoses;
            }
            state.counters["iterations"] =
                benchmark::Counter(static_cast<double>(iterations), benchmark::Counter::kAvgIterations);
        });
}

void addSolver(const Jobs& jobs, const std::string& what, std::shared_ptr<const ForwardSolver> solver) {
    add(jobs, what, [solver](const LegLengths& lengths, const Pose& start) {
        const ForwardResult result = solver->solve(lengths, start);
        benchmark::DoNotOptimize(result.pose.offset[0]);
        return result.iterations;
    });
}

void addYardsticks(const Jobs& jobs) {
    static const YardstickMachine machine = yardstickMachine(laboratory());
    const auto one = [](auto newton) {
        return [newton](const LegLengths& lengths, const Pose& start) {
            PoseVector pose = start.toVector();
            const int iterations = newton(machine, lengths.data(), pose.data(), kTolerance);
            benchmark::DoNotOptimize(pose[0]);
            return iterations;
        };
    };
    add(jobs, "yardstick", one(&plainNewton));
    add(jobs, "yardstick, this processor", one(&plainNewtonNative));
}

/// target: 0 for the best vector unit there is.
void addBatch(const Jobs& jobs, std::shared_ptr<const NewtonRaphson> newton, std::int64_t target) {
    const std::string unit = target == 0 ? "" : std::string(" with ") + hwy::TargetName(target);
    benchmark::RegisterBenchmark((jobs.name + " / Newton, batch" + unit).c_str(),
                                 [&jobs, newton, target](benchmark::State& state) {
                                     const testing_support::OnlyVectorUnit only(target);
                                     std::vector<ForwardResult> results(kPoses);
                                     for (auto _ : state) {
                                         newton->solveAll(jobs.lengths, results);
                                         benchmark::DoNotOptimize(results.data());
                                     }
                                     state.counters["poses"] = kPoses;
                                     if (jobs.name == "cold, set 2")
                                         state.counters["flops"] = kFlopsOfBatch;
                                 });
}

/// On the best vector unit, and on each of the others that this processor has.
void addBatches(const Jobs& jobs, const std::shared_ptr<const NewtonRaphson>& newton) {
    std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    targets.front() = 0;
    for (const std::int64_t target : targets)
        addBatch(jobs, newton, target);
}

void addRegression(const Jobs& jobs, int degree) {
    add(jobs, "MPR" + std::to_string(degree) + " alone",
        [fitted = model(degree)](const LegLengths& lengths, const Pose&) {
            benchmark::DoNotOptimize(fitted.evaluate(lengths)[0]);
            return 0;
        });
}

/// One step of finite-step integration, from paths of 100: the start, the rigid fit and the measure of how
/// singular the end is are shared out among them.
void addFiniteSteps(const Jobs& jobs) {
    constexpr int kSteps = 100;
    static const LegPath path(laboratory());
    for (const StepForm form : {StepForm::Open, StepForm::Closed, StepForm::Corrected})
        benchmark::RegisterBenchmark(
            ("one step of FSI, " + std::string(toWord(form))).c_str(),
            [&jobs, form](benchmark::State& state) {
                std::size_t next = 0;
                for (auto _ : state) {
                    benchmark::DoNotOptimize(path.followStraight(Pose{}, jobs.lengths[next], kSteps, form).q);
                    next = (next + 1) % kPoses;
                }
                state.counters["poses"] = kSteps; // the report divides by it
            });
    addSolver(jobs, "FSI, 100 steps, corrected",
              std::make_shared<const FiniteStepSolver>(laboratory(), FiniteStepOptions{kSteps}));
}

/// What the vector unit can do at best.
void addPeak() {
    benchmark::RegisterBenchmark("peak of the vector unit", [](benchmark::State& state) {
        constexpr long kRounds = 1000;
        for (auto _ : state)
            benchmark::DoNotOptimize(multiplyAdds(kRounds));
        state.counters["flops"] = multiplyAddFlops(kRounds);
    });
}

void addTraining() {
    benchmark::RegisterBenchmark("training, 100,000 samples, degree 3, all cores", [](benchmark::State&
                                                                                          state) {
        const TrainingSpec spec = defaultTrainingSpec(laboratory(), 3);
        for (auto _ : state)
            benchmark::DoNotOptimize(trainModel(laboratory(), spec)->coefficientRows.data());
    })->UseRealTime();
}

} // namespace

hexapose::bench::YardstickMachine hexapose::bench::yardstickMachine(const PlatformGeometry& geometry) {
    YardstickMachine machine{};
    for (std::size_t i = 0; i < kLegCount; ++i)
        for (int k = 0; k < 3; ++k) {
            machine.base[i][k] = geometry.legs[i].p_OA_B[k];
            machine.joint[i][k] = geometry.legs[i].p_PB_P[k];
            machine.home[k] = geometry.p_OP_home_B[k];
        }
    return machine;
}

int main(int argc, char** argv) {
    // Short and often, in random order: the machine may be shared. Options given by hand come later and win.
    std::vector<std::string> words{argv[0], "--benchmark_repetitions=25", "--benchmark_min_time=0.01",
                                   "--benchmark_enable_random_interleaving=true"};
    words.insert(words.end(), argv + 1, argv + argc);
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
        return 2;

    const Jobs sets[] = {makeJobs("cold, set 1", 1, Start::Home), makeJobs("cold, set 2", 2, Start::Home),
                         makeJobs("warm", 2, Start::Near)};
    const NewtonOptions options{kTolerance, 50};
    const auto newton = std::make_shared<const NewtonRaphson>(laboratory(), options);
    const auto mpr2 = std::make_shared<const MprNewton>(laboratory(), model(2), options);
    const auto mpr3 = std::make_shared<const MprNewton>(laboratory(), model(3), options);
    for (const Jobs& jobs : sets) {
        addYardsticks(jobs);
        addSolver(jobs, "Newton", newton);
    }
    for (const Jobs& jobs : {std::cref(sets[0]), std::cref(sets[1])}) {
        addSolver(jobs, "MPR2-NR", mpr2);
        addSolver(jobs, "MPR3-NR", mpr3);
        addBatches(jobs, newton);
    }
    addSolver(sets[1], "Newton as published",
              std::make_shared<const NewtonAsPublished>(laboratory(), options));
    for (const int degree : {2, 3, 4})
        addRegression(sets[1], degree);
    addFiniteSteps(sets[0]);
    addPlanning(laboratory());
    addPeak();
    addTraining();
    RatioReport report;
    benchmark::RunSpecifiedBenchmarks(&report);
    return 0;
}
