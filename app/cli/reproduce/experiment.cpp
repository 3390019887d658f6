// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/experiment.h"

#include "core/base/units.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/pose_samples.h"
#include "core/kinematics/regression/polynomial_training.h"
#include "core/kinematics/solver_checks.h"
#include "core/kinematics/vector/parallel_lanes.h"

#include <algorithm>
#include <ctime>

namespace hexapose::reproduce {

namespace {

constexpr std::uint64_t kTrainingSeed = 1;
constexpr std::uint64_t kTestSeed = 3082; // streams of another seed: no test pose was trained on
/// Poses solved in one go; sums are formed within each part and then in the order of the parts.
constexpr std::size_t kPart = 500;

TrainingSpec specOf(int set, int degree, std::int64_t samples) {
    const double range = published::kSetRange[static_cast<std::size_t>(set - 1)];
    return {degree, metresFromMm(range), radiansFromDeg(range), samples, kTrainingSeed};
}

int modelDegree(Algorithm algorithm) {
    switch (algorithm) {
    case Algorithm::Newton:
        return 0;
    case Algorithm::Mpr2:
    case Algorithm::Mpr2Newton:
        return 2;
    case Algorithm::Mpr3:
    case Algorithm::Mpr3Newton:
        break;
    }
    return 3;
}

bool iterates(Algorithm algorithm) {
    return algorithm != Algorithm::Mpr2 && algorithm != Algorithm::Mpr3;
}

std::unique_ptr<ForwardSolver> makeNewton(const PlatformGeometry& platform, const Procedure& procedure) {
    const NewtonOptions options{procedure.tolerance, procedure.maxIterations};
    if (!iterates(procedure.algorithm))
        return nullptr;
    if (procedure.jacobian == Jacobian::AsPublished)
        return std::make_unique<NewtonAsPublished>(platform, options);
    return std::make_unique<NewtonRaphson>(platform, options);
}

/// The regression, where there is one; Newton from there or from home, but not where the regression meets
/// the tolerance already (section 2.6).
ForwardResult solve(const PlatformGeometry& platform, const PolynomialModel* model,
                    const ForwardSolver* newton, double tolerance, const LegLengths& lengths) {
    ForwardResult result;
    if (model != nullptr) {
        result.pose = Pose::fromVector(model->evaluate(lengths));
        result.status = SolveStatus::Converged;
        if (newton == nullptr || legResidual(platform, lengths, result.pose) < tolerance)
            return result;
    }
    return newton->solve(lengths, result.pose);
}

/// What this thread has had of a core; other programs on the machine do not count.
double threadSeconds() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

Experiment::Experiment(const PlatformGeometry& platform, const ExperimentSize& size, unsigned threads)
    : m_platform(platform), m_size(size), m_threads(threads) {}

const PolynomialModel& Experiment::model(int set, int degree) {
    const std::pair key(set, degree);
    for (const auto& [known, model] : m_models)
        if (known == key)
            return *model;
    auto model = trainModel(m_platform, specOf(set, degree, m_size.training), {}, m_threads);
    m_models.emplace_back(key, std::make_unique<PolynomialModel>(std::move(*model))); // never cancelled
    return *m_models.back().second;
}

const std::vector<Experiment::TestPose>& Experiment::testPoses(int set) {
    std::vector<TestPose>& poses = m_testPoses[static_cast<std::size_t>(set - 1)];
    if (poses.empty()) {
        const TrainingSpec box = specOf(set, 1, 1);
        PoseSamples samples(box.offsetRange, box.angleRange, kTestSeed, static_cast<std::uint64_t>(set));
        for (int i = 0; i < m_size.test; ++i) {
            const Pose truth = samples.next();
            poses.push_back({truth, legLengths(m_platform, truth)});
        }
    }
    return poses;
}

const MethodRun& Experiment::run(const Procedure& procedure) {
    for (const auto& [known, run] : m_runs)
        if (known == procedure)
            return *run;
    m_runs.emplace_back(procedure, std::make_unique<MethodRun>(measure(procedure)));
    return *m_runs.back().second;
}

MethodRun Experiment::measure(const Procedure& procedure) {
    const std::vector<TestPose>& poses = testPoses(procedure.set);
    const int degree = modelDegree(procedure.algorithm);
    const PolynomialModel* regression = degree == 0 ? nullptr : &model(procedure.set, degree);
    const std::unique_ptr<ForwardSolver> newton = makeNewton(m_platform, procedure);
    std::vector<MethodRun> parts((poses.size() + kPart - 1) / kPart);
    runLanes(
        static_cast<int>(parts.size()), m_threads,
        [&](int lane) {
            const auto part = static_cast<std::size_t>(lane);
            parts[part] = measureSome(poses, part * kPart, std::min(poses.size(), (part + 1) * kPart),
                                      regression, newton.get(), procedure);
        },
        [] {});
    MethodRun whole;
    for (const MethodRun& part : parts) {
        whole.meanError += part.meanError;
        whole.meanDistance += part.meanDistance;
        whole.poses += part.poses;
        whole.iterations += part.iterations;
        whole.unsolved += part.unsolved;
        whole.seconds += part.seconds;
    }
    whole.meanError /= whole.poses;
    whole.meanDistance /= whole.poses;
    return whole;
}

/// Sums in place of means.
MethodRun Experiment::measureSome(const std::vector<TestPose>& poses, std::size_t first, std::size_t last,
                                  const PolynomialModel* model, const ForwardSolver* newton,
                                  const Procedure& procedure) const {
    std::array<ForwardResult, kPart> results;
    const double start = threadSeconds();
    for (std::size_t i = first; i < last; ++i)
        results[i - first] = solve(m_platform, model, newton, procedure.tolerance, poses[i].lengths);
    MethodRun run;
    run.seconds = threadSeconds() - start;
    run.poses = static_cast<int>(last - first);
    for (std::size_t i = first; i < last; ++i) {
        const ForwardResult& result = results[i - first];
        const PoseVector error = result.pose.toVector() - poses[i].truth.toVector();
        run.meanError += error.cwiseAbs();
        run.meanDistance += error.norm();
        run.iterations += result.iterations;
        run.unsolved += result.status == SolveStatus::Converged ? 0 : 1;
    }
    return run;
}

} // namespace hexapose::reproduce
