// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/kinematics/polynomial_training.h"

#include "core/geometry/input_error.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton_raphson.h"
#include "core/kinematics/polynomial_basis.h"
#include "core/kinematics/random_poses.h"
#include "core/kinematics/solver_checks.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <numbers>
#include <thread>
#include <vector>

namespace hexapose {

namespace {

/// The work is cut into so many parts whatever the number of threads; each has its own random stream and its
/// own sums, which are added in order. So the result depends on the specification alone.
constexpr int kParts = 16;
constexpr Eigen::Index kBlock = 256;       ///< poses a block: its monomials stay in the cache
constexpr std::int64_t kPilotPoses = 2000; ///< for centre and scale of the lengths
constexpr std::uint64_t kPilotStream = 1000;
constexpr double kFitShare = 0.85; ///< of the progress; the rest is the pass that measures the residual
constexpr std::chrono::milliseconds kReportEvery{30};

using Monomials = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

struct PartSums {
    Monomials normal; ///< lower triangle of sum m m^T
    Eigen::Matrix<double, Eigen::Dynamic, 6> right;
    LegLengths minLength = LegLengths::Constant(std::numeric_limits<double>::infinity());
    LegLengths maxLength = LegLengths::Zero();
    double maxResidual = 0.0;
};

std::int64_t partSamples(const TrainingSpec& spec, int part) {
    return spec.samples / kParts + (part < spec.samples % kParts ? 1 : 0);
}

RandomPoses partPoses(const TrainingSpec& spec, int part) {
    return {spec.offsetRange, spec.angleRange, spec.seed, static_cast<std::uint64_t>(part) + 1};
}

/// Runs `work(part, tick)` for every part on several threads; tick(samples) is called now and then and says
/// whether to go on. The calling thread only reports. False: cancelled.
class PartRunner {
public:
    using Tick = std::function<bool(std::int64_t)>;

    PartRunner(unsigned threads, std::int64_t samples, TrainingProgress progress, double from, double to)
        : m_threads(threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency())),
          m_samples(samples), m_progress(std::move(progress)), m_from(from), m_to(to) {}

    template <typename Work>
    bool run(const Work& work) {
        const Tick tick = [this](std::int64_t done) {
            m_done += done;
            return !m_cancelled;
        };
        std::vector<std::jthread> workers;
        for (unsigned k = 0; k < std::min<unsigned>(m_threads, kParts); ++k)
            workers.emplace_back([&] {
                for (int part = m_nextPart++; part < kParts && !m_cancelled; part = m_nextPart++)
                    work(part, tick);
                const std::lock_guard lock(m_mutex);
                ++m_finished;
                m_changed.notify_one();
            });
        report(static_cast<unsigned>(workers.size()));
        return !m_cancelled;
    }

private:
    void report(unsigned workers) {
        std::unique_lock lock(m_mutex);
        while (!m_changed.wait_for(lock, kReportEvery, [&] { return m_finished == workers; })) {
            lock.unlock();
            tell(static_cast<double>(m_done) / static_cast<double>(m_samples));
            lock.lock();
        }
        lock.unlock();
        if (!m_cancelled)
            tell(1.0);
    }
    void tell(double part) {
        if (m_progress && !m_progress(m_from + (m_to - m_from) * part))
            m_cancelled = true;
    }

    unsigned m_threads;
    std::int64_t m_samples;
    TrainingProgress m_progress;
    double m_from;
    double m_to;
    std::atomic<int> m_nextPart{0};
    std::atomic<std::int64_t> m_done{0};
    std::atomic<bool> m_cancelled{false};
    std::mutex m_mutex;
    std::condition_variable m_changed;
    unsigned m_finished = 0;
};

void check(const PlatformGeometry& geometry, const TrainingSpec& spec) {
    const auto refuse = [&](const std::string& cause) { throw InputError("training", cause); };
    if (spec.degree < 1 || spec.degree > kMaxDegree)
        refuse("degree " + std::to_string(spec.degree) + " is not 1 to 4");
    if (!(spec.offsetRange > 0.0) || !std::isfinite(spec.offsetRange))
        refuse("the displacement range is not a number above 0");
    if (!(spec.angleRange > 0.0) || !(spec.angleRange <= std::numbers::pi))
        refuse("the angle range is not above 0 and at most 180 deg");
    if (spec.samples < static_cast<std::int64_t>(monomialCount(spec.degree)))
        refuse(std::to_string(spec.samples) + " samples are fewer than the " +
               std::to_string(monomialCount(spec.degree)) + " monomials of degree " +
               std::to_string(spec.degree));
    if (homeDeterminant(geometry) == 0.0)
        refuse("the platform is singular at home");
}

void scaleLengths(const PlatformGeometry& geometry, PolynomialModel& model) {
    RandomPoses poses(model.spec.offsetRange, model.spec.angleRange, model.spec.seed, kPilotStream);
    LegLengths least = geometry.homeLengths();
    LegLengths most = least;
    for (std::int64_t k = 0; k < kPilotPoses; ++k) {
        const LegLengths lengths = legLengths(geometry, poses());
        least = least.cwiseMin(lengths);
        most = most.cwiseMax(lengths);
    }
    model.lengthCentre = 0.5 * (least + most);
    model.lengthScale = 0.5 * (most - least);
}

void sumPart(const PlatformGeometry& geometry, const PolynomialModel& model, int part, PartSums& sums,
             const PartRunner::Tick& tick) {
    const auto count = static_cast<Eigen::Index>(monomialCount(model.spec.degree));
    sums.normal = Monomials::Zero(count, count);
    sums.right = Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(count, 6);
    Monomials monomials(count, kBlock);
    Eigen::Matrix<double, 6, Eigen::Dynamic> poses(6, kBlock);
    RandomPoses random = partPoses(model.spec, part);
    for (std::int64_t left = partSamples(model.spec, part); left > 0;) {
        const Eigen::Index size = std::min<std::int64_t>(left, kBlock);
        for (Eigen::Index k = 0; k < size; ++k) {
            const Pose pose = random();
            const LegLengths lengths = legLengths(geometry, pose);
            sums.minLength = sums.minLength.cwiseMin(lengths);
            sums.maxLength = sums.maxLength.cwiseMax(lengths);
            const LegVector u = (lengths - model.lengthCentre).cwiseQuotient(model.lengthScale);
            fillMonomials(u, static_cast<std::size_t>(count), monomials.col(k).data());
            poses.col(k) = pose.toVector();
        }
        sums.normal.selfadjointView<Eigen::Lower>().rankUpdate(monomials.leftCols(size));
        sums.right.noalias() += monomials.leftCols(size) * poses.leftCols(size).transpose();
        left -= size;
        if (!tick(size))
            return;
    }
}

void measurePart(const PlatformGeometry& geometry, const PolynomialModel& model, int part, PartSums& sums,
                 const PartRunner::Tick& tick) {
    RandomPoses random = partPoses(model.spec, part);
    for (std::int64_t left = partSamples(model.spec, part); left > 0;) {
        const std::int64_t size = std::min<std::int64_t>(left, kBlock);
        for (std::int64_t k = 0; k < size; ++k) {
            const LegLengths lengths = legLengths(geometry, random());
            const Pose found = Pose::fromVector(model.evaluate(lengths));
            sums.maxResidual = std::max(sums.maxResidual, legResidual(geometry, lengths, found));
        }
        left -= size;
        if (!tick(size))
            return;
    }
}

void fit(const std::vector<PartSums>& parts, PolynomialModel& model) {
    Monomials normal = parts.front().normal;
    Eigen::Matrix<double, Eigen::Dynamic, 6> right = parts.front().right;
    model.minLength = parts.front().minLength;
    model.maxLength = parts.front().maxLength;
    for (auto part = parts.begin() + 1; part != parts.end(); ++part) {
        normal += part->normal;
        right += part->right;
        model.minLength = model.minLength.cwiseMin(part->minLength);
        model.maxLength = model.maxLength.cwiseMax(part->maxLength);
    }
    const Eigen::LDLT<Monomials, Eigen::Lower> factors(normal);
    model.coefficients = factors.solve(right).transpose();
    if (factors.info() != Eigen::Success || !model.coefficients.allFinite())
        throw InputError("training",
                         "the poses do not determine the polynomial: more samples, or a wider range");
}

} // namespace

std::optional<PolynomialModel> trainModel(const PlatformGeometry& geometry, const TrainingSpec& spec,
                                          const TrainingProgress& progress, unsigned threads) {
    check(geometry, spec);
    PolynomialModel model;
    model.spec = spec;
    model.platformFingerprint = geometry.fingerprint();
    scaleLengths(geometry, model);

    std::vector<PartSums> parts(kParts);
    const auto partOf = [&](int part) -> PartSums& { return parts[static_cast<std::size_t>(part)]; };
    PartRunner fitting(threads, spec.samples, progress, 0.0, kFitShare);
    if (!fitting.run([&](int part, const PartRunner::Tick& tick) {
            sumPart(geometry, model, part, partOf(part), tick);
        }))
        return std::nullopt;
    fit(parts, model);

    PartRunner measuring(threads, spec.samples, progress, kFitShare, 1.0);
    if (!measuring.run([&](int part, const PartRunner::Tick& tick) {
            measurePart(geometry, model, part, partOf(part), tick);
        }))
        return std::nullopt;
    for (const PartSums& part : parts)
        model.maxResidual = std::max(model.maxResidual, part.maxResidual);
    return model;
}

ModelErrors testModel(const PlatformGeometry& geometry, const PolynomialModel& model, std::int64_t samples,
                      std::uint64_t seed) {
    RandomPoses random(model.spec.offsetRange, model.spec.angleRange, seed);
    ModelErrors errors;
    for (std::int64_t k = 0; k < samples; ++k) {
        const Pose pose = random();
        const PoseVector error = (model.evaluate(legLengths(geometry, pose)) - pose.toVector()).cwiseAbs();
        errors.meanAbsolute += error / static_cast<double>(samples);
        errors.largest = errors.largest.cwiseMax(error);
    }
    return errors;
}

} // namespace hexapose
