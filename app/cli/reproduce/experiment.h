// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/published_tables.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"
#include "core/kinematics/forward_solver.h"
#include "core/kinematics/regression/polynomial_model.h"

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace hexapose::reproduce {

using published::Algorithm;

enum class Jacobian { AsPublished, Exact };

/// One method on one set of test poses.
struct Procedure {
    Algorithm algorithm = Algorithm::Newton;
    int set = 1;
    Jacobian jacobian = Jacobian::AsPublished;
    double tolerance = published::kTolerance;
    int maxIterations = published::kMaxIterations;
    bool operator==(const Procedure&) const = default;
};

/// What it came to. All but the seconds is the same on every run and for every number of threads.
struct MethodRun {
    PoseVector meanError = PoseVector::Zero(); ///< mean absolute error, m and rad
    double meanDistance = 0.0;                 ///< mean Euclidean distance of the pose vectors
    int poses = 0;
    int iterations = 0;   ///< Newton iterations of all poses together
    int unsolved = 0;     ///< poses whose iteration ended before its stop test was met
    double seconds = 0.0; ///< of one core, for all poses

    double meanIterations() const { return static_cast<double>(iterations) / poses; }
};

struct ExperimentSize {
    std::int64_t training = published::kTrainingPoses;
    int test = published::kTestPoses;
};

/// The published simulation: regressions fitted to the poses of a set, and methods tried on fresh poses of
/// it. Models, test poses and runs are kept, so that tables that share a run share its numbers.
class Experiment {
public:
    /// threads: 0 for as many as the machine has.
    explicit Experiment(const PlatformGeometry& platform, const ExperimentSize& size = {},
                        unsigned threads = 0);

    const PlatformGeometry& platform() const { return m_platform; }
    const ExperimentSize& size() const { return m_size; }
    const MethodRun& run(const Procedure& procedure);
    const PolynomialModel& model(int set, int degree);

private:
    struct TestPose {
        Pose truth;
        LegLengths lengths;
    };
    const std::vector<TestPose>& testPoses(int set);
    MethodRun measure(const Procedure& procedure);
    MethodRun measureSome(const std::vector<TestPose>& poses, std::size_t first, std::size_t last,
                          const PolynomialModel* model, const ForwardSolver* newton,
                          const Procedure& procedure) const;

    PlatformGeometry m_platform;
    ExperimentSize m_size;
    unsigned m_threads;
    std::array<std::vector<TestPose>, 2> m_testPoses;
    std::vector<std::pair<std::pair<int, int>, std::unique_ptr<PolynomialModel>>>
        m_models; ///< by set, degree
    std::vector<std::pair<Procedure, std::unique_ptr<MethodRun>>> m_runs;
};

} // namespace hexapose::reproduce
