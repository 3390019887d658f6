// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/regression/polynomial_training.h"

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/pose_samples.h"
#include "core/kinematics/regression/polynomial_basis.h"
#include "core/kinematics/vector/parallel_lanes.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <string>

namespace hexapose {

namespace {

/// Samples are drawn in blocks, blocks belong to lanes, and lanes are added up in their order: the sums do
/// not depend on how many threads there are. Memory does not grow with the samples.
constexpr int kBlock = 256;
constexpr int kLanes = 16;
/// Pivot of the scaled normal matrix below which a monomial is a combination of the others.
constexpr double kSmallestPivot = 1e-14;

using Samples = Eigen::Matrix<double, kBlock, Eigen::Dynamic>;

[[noreturn]] void refuse(const std::string& cause) {
    throw InputError("training", cause);
}

void checkSpec(const TrainingSpec& spec) {
    if (spec.degree < kMinDegree || spec.degree > kMaxDegree)
        refuse("degree " + std::to_string(spec.degree) + " is not one of 1 to 4");
    if (!(spec.offsetRange > 0.0) || !std::isfinite(spec.offsetRange))
        refuse("the displacement range " + formatNumber(spec.offsetRange) + " m is not positive and finite");
    if (!(spec.angleRange > 0.0) || !std::isfinite(spec.angleRange))
        refuse("the angle range " + formatNumber(spec.angleRange) + " rad is not positive and finite");
    if (spec.samples < monomialCount(spec.degree))
        refuse(std::to_string(spec.samples) + " samples are fewer than the " +
               std::to_string(monomialCount(spec.degree)) + " monomials of degree " +
               std::to_string(spec.degree));
}

/// What one lane finds in each pass.
struct Lane {
    LegLengths minLength = LegLengths::Constant(HUGE_VAL), maxLength = LegLengths::Constant(-HUGE_VAL);
    Eigen::MatrixXd normal, moments;
    double maxResidual = 0.0;
    PoseVector maxError = PoseVector::Zero();
};

class Training {
public:
    Training(const PlatformGeometry& geometry, const TrainingSpec& spec, const TrainingProgress& progress,
             unsigned threads)
        : m_geometry(geometry), m_spec(spec), m_progress(progress), m_threads(threads),
          m_blocks((spec.samples + kBlock - 1) / kBlock) {
        m_model.spec = spec;
        m_model.platformFingerprint = geometry.fingerprint();
        m_range << Eigen::Vector3d::Constant(spec.offsetRange), Eigen::Vector3d::Constant(spec.angleRange);
    }

    std::optional<PolynomialModel> run() {
        if (!pass(0.0, 0.1, &Training::rangeBlock))
            return std::nullopt;
        setScaling();
        for (Lane& lane : m_lanes) {
            lane.normal.setZero(monomials(), monomials());
            lane.moments.setZero(monomials(), 6);
        }
        if (!pass(0.1, 0.8, &Training::normalBlock))
            return std::nullopt;
        fit();
        if (!pass(0.8, 1.0, &Training::residualBlock))
            return std::nullopt;
        for (const Lane& lane : m_lanes) {
            m_model.maxResidual = std::max(m_model.maxResidual, lane.maxResidual);
            m_model.maxError = m_model.maxError.cwiseMax(lane.maxError);
        }
        return std::move(m_model);
    }

private:
    using BlockWork = void (Training::*)(Lane&, PoseSamples&, int count) const;

    int monomials() const { return monomialCount(m_spec.degree); }

    /// One walk over all samples. False: cancelled.
    bool pass(double from, double to, BlockWork work) {
        std::atomic<std::int64_t> done = 0;
        std::atomic<bool> cancelled = false;
        const auto walk = [&](int lane) {
            for (std::int64_t block = lane; block < m_blocks && !cancelled; block += kLanes) {
                PoseSamples samples(m_spec.offsetRange, m_spec.angleRange, m_spec.seed,
                                    static_cast<std::uint64_t>(block));
                const auto count = std::min<std::int64_t>(kBlock, m_spec.samples - block * kBlock);
                (this->*work)(m_lanes[static_cast<std::size_t>(lane)], samples, static_cast<int>(count));
                ++done;
            }
        };
        runLanes(kLanes, m_threads, walk, [&] {
            const double part = static_cast<double>(done) / static_cast<double>(m_blocks);
            if (m_progress && !cancelled && !m_progress(from + (to - from) * part))
                cancelled = true;
        });
        return !cancelled;
    }

    void rangeBlock(Lane& lane, PoseSamples& samples, int count) const {
        for (int i = 0; i < count; ++i) {
            const LegLengths lengths = legLengths(m_geometry, samples.next());
            lane.minLength = lane.minLength.cwiseMin(lengths);
            lane.maxLength = lane.maxLength.cwiseMax(lengths);
        }
    }

    void setScaling() {
        m_model.minLength = m_lanes[0].minLength;
        m_model.maxLength = m_lanes[0].maxLength;
        for (const Lane& lane : m_lanes) {
            m_model.minLength = m_model.minLength.cwiseMin(lane.minLength);
            m_model.maxLength = m_model.maxLength.cwiseMax(lane.maxLength);
        }
        m_model.lengthCentre = 0.5 * (m_model.minLength + m_model.maxLength);
        m_model.lengthScale = 0.5 * (m_model.maxLength - m_model.minLength);
        for (int i = 0; i < kLegCount; ++i)
            if (!(m_model.minLength[i] > 0.0) || !(m_model.lengthScale[i] > 0.0) ||
                !std::isfinite(m_model.maxLength[i]))
                refuse("leg " + std::to_string(i + 1) + " has no usable lengths in this range");
    }

    void normalBlock(Lane& lane, PoseSamples& samples, int count) const {
        Eigen::Matrix<double, kBlock, kLegCount> u;
        Eigen::Matrix<double, kBlock, 6> poses;
        u.setZero();
        poses.setZero();
        for (int i = 0; i < count; ++i) {
            const Pose pose = samples.next();
            u.row(i) = (legLengths(m_geometry, pose) - m_model.lengthCentre)
                           .cwiseQuotient(m_model.lengthScale)
                           .transpose();
            poses.row(i) = pose.toVector().cwiseQuotient(m_range).transpose();
        }
        Samples x(kBlock, monomials());
        x.col(0).setZero();
        x.col(0).head(count).setOnes();
        forEachMonomialRun(m_spec.degree, [&](int variable, int parent, int child, int run) {
            for (int i = 0; i < run; ++i)
                x.col(child + i) = x.col(parent + i).cwiseProduct(u.col(variable));
        });
        lane.normal.selfadjointView<Eigen::Lower>().rankUpdate(x.transpose());
        lane.moments.noalias() += x.transpose() * poses;
    }

    void fit() {
        Eigen::MatrixXd normal = m_lanes[0].normal, moments = m_lanes[0].moments;
        for (std::size_t i = 1; i < m_lanes.size(); ++i) {
            normal += m_lanes[i].normal;
            moments += m_lanes[i].moments;
        }
        const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().cwiseInverse();
        normal = scale.asDiagonal() * normal * scale.asDiagonal();
        const Eigen::LDLT<Eigen::MatrixXd, Eigen::Lower> factor(normal);
        if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > kSmallestPivot))
            refuse("the samples do not determine a polynomial of degree " + std::to_string(m_spec.degree) +
                   "; take more samples, a wider range or a lower degree");
        const Eigen::MatrixXd fitted = scale.asDiagonal() * factor.solve(scale.asDiagonal() * moments);
        m_model.setCoefficients(m_range.asDiagonal() * fitted.transpose());
    }

    void residualBlock(Lane& lane, PoseSamples& samples, int count) const {
        for (int i = 0; i < count; ++i) {
            const Pose truth = samples.next();
            const LegLengths lengths = legLengths(m_geometry, truth);
            const PoseVector found = m_model.evaluate(lengths);
            const double residual = (lengths - legLengths(m_geometry, Pose::fromVector(found))).norm();
            lane.maxResidual = std::max(lane.maxResidual, residual);
            lane.maxError = lane.maxError.cwiseMax((found - truth.toVector()).cwiseAbs());
        }
    }

    const PlatformGeometry& m_geometry;
    const TrainingSpec& m_spec;
    const TrainingProgress& m_progress;
    const unsigned m_threads;
    const std::int64_t m_blocks;
    PoseVector m_range; ///< what the coordinates are divided by in the fit
    std::array<Lane, kLanes> m_lanes;
    PolynomialModel m_model;
};

} // namespace

std::optional<PolynomialModel> trainModel(const PlatformGeometry& geometry, const TrainingSpec& spec,
                                          const TrainingProgress& progress, unsigned threads) {
    if (PlatformModel(geometry).homeDeterminant() == 0.0)
        refuse("the geometry is singular at home");
    const TrainingSpec complete = withDefaults(spec, geometry);
    checkSpec(complete);
    return Training(geometry, complete, progress, threads).run();
}

ModelErrors testModel(const PlatformGeometry& geometry, const PolynomialModel& model, std::int64_t samples,
                      std::uint64_t seed) {
    // Training streams are numbered from 0; a fresh set under the same seed must not repeat them.
    PoseSamples poses(model.spec.offsetRange, model.spec.angleRange, seed, ~std::uint64_t{0});
    ModelErrors errors;
    for (std::int64_t i = 0; i < samples; ++i) {
        const Pose truth = poses.next();
        const PoseVector error = (model.evaluate(legLengths(geometry, truth)) - truth.toVector()).cwiseAbs();
        errors.meanAbsolute += error;
        errors.largest = errors.largest.cwiseMax(error);
    }
    errors.meanAbsolute /= static_cast<double>(std::max<std::int64_t>(samples, 1));
    return errors;
}

} // namespace hexapose
