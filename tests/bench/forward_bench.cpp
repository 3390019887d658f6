// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Time of one forward solution, in ns, on one thread. Cold: start at home. Set 1: +-10 mm +-10 deg; set 2:
// +-40 mm
// +-40 deg. "warm": start 0.1 mm and 0.1 deg beside the solution. All to a leg residual of 1e-10 m.
#include "core/geometry/geometry_file.h"
#include "core/geometry/units.h"
#include "core/kinematics/mpr_newton.h"
#include "core/kinematics/polynomial_training.h"
#include "yardstick.h"

#include <Eigen/Geometry>
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace {

using namespace hexapose;

constexpr double kTolerance = 1e-10;
constexpr int kPoses = 4096;

struct Job {
    LegLengths lengths;
    Pose start;
};

enum class Start { Home, Near };

const PlatformGeometry& laboratory() {
    static const PlatformGeometry geometry =
        loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
    return geometry;
}

std::vector<Job> jobs(int set, Start start) {
    std::mt19937_64 random(7);
    const auto draw = [&random](double mm, double deg) {
        PoseVector v;
        for (int i = 0; i < 6; ++i)
            v[i] = (static_cast<double>(random() >> 11) * 0x1p-52 - 1.0) *
                   (i < 3 ? metresFromMm(mm) : radiansFromDeg(deg));
        return v;
    };
    const double range = set == 1 ? 10.0 : 40.0;
    std::vector<Job> result(kPoses);
    for (Job& job : result) {
        const PoseVector truth = draw(range, range);
        job.lengths = legLengths(laboratory(), Pose::fromVector(truth));
        if (start == Start::Near)
            job.start = Pose::fromVector(truth + draw(0.1, 0.1));
    }
    return result;
}

const PolynomialModel& model(int degree) {
    static std::vector<PolynomialModel> models(5);
    PolynomialModel& kept = models[static_cast<std::size_t>(degree)];
    if (kept.coefficients.size() == 0)
        kept = *trainModel(laboratory(), defaultTrainingSpec(laboratory(), degree));
    return kept;
}

/// Runs solveOne(job) -> iterations over the jobs, one a benchmark iteration.
template <class Solve>
void measure(benchmark::State& state, const std::vector<Job>& work, Solve&& solveOne) {
    std::size_t next = 0;
    std::int64_t iterations = 0;
    for (auto _ : state) {
        iterations += solveOne(work[next]);
        next = (next + 1) % work.size();
    }
    state.counters["iterations"] =
        benchmark::Counter(static_cast<double>(iterations), benchmark::Counter::kAvgIterations);
}

void solverBench(benchmark::State& state, const ForwardSolver& solver, int set, Start start) {
    measure(state, jobs(set, start), [&solver](const Job& job) {
        const ForwardResult result = solver.solve(job.lengths, job.start);
        benchmark::DoNotOptimize(result.pose);
        return result.iterations;
    });
}

void yardstick(benchmark::State& state, int set, Start start) {
    measure(state, jobs(set, start), [](const Job& job) {
        Pose pose = job.start;
        const int iterations = bench::plainNewton(laboratory(), job.lengths, pose, kTolerance);
        benchmark::DoNotOptimize(pose);
        return iterations;
    });
}

void newton(benchmark::State& state, int set, Start start) {
    solverBench(state, NewtonRaphson(laboratory(), {kTolerance, 50}), set, start);
}

void asPublished(benchmark::State& state, int set) {
    solverBench(state, NewtonAsPublished(laboratory(), {kTolerance, 50}), set, Start::Home);
}

void mprNewton(benchmark::State& state, int degree, int set) {
    solverBench(state, MprNewton(laboratory(), model(degree), {kTolerance, 50}), set, Start::Home);
}

void regression(benchmark::State& state, int degree) {
    const PolynomialModel& fitted = model(degree);
    measure(state, jobs(2, Start::Home), [&fitted](const Job& job) {
        benchmark::DoNotOptimize(fitted.evaluate(job.lengths));
        return 0;
    });
}

void training(benchmark::State& state, int degree) {
    const TrainingSpec spec = defaultTrainingSpec(laboratory(), degree);
    for (auto _ : state)
        benchmark::DoNotOptimize(trainModel(laboratory(), spec)->coefficients.data());
}

BENCHMARK_CAPTURE(yardstick, cold_set1, 1, Start::Home);
BENCHMARK_CAPTURE(yardstick, cold_set2, 2, Start::Home);
BENCHMARK_CAPTURE(yardstick, warm, 2, Start::Near);
BENCHMARK_CAPTURE(newton, cold_set1, 1, Start::Home);
BENCHMARK_CAPTURE(newton, cold_set2, 2, Start::Home);
BENCHMARK_CAPTURE(newton, warm, 2, Start::Near);
BENCHMARK_CAPTURE(mprNewton, mpr2_nr_set2, 2, 2);
BENCHMARK_CAPTURE(mprNewton, mpr3_nr_set2, 3, 2);
BENCHMARK_CAPTURE(asPublished, cold_set2, 2);
BENCHMARK_CAPTURE(regression, mpr2, 2);
BENCHMARK_CAPTURE(regression, mpr3, 3);
BENCHMARK_CAPTURE(training, samples_100000_degree3, 3)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace

BENCHMARK_MAIN();
