// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/catalog/forward_methods.h"
#include "core/kinematics/regression/mpr_newton.h"
#include "core/kinematics/regression/polynomial_basis.h"
#include "core/kinematics/regression/polynomial_training.h"

#include "core/base/input_error.h"
#include "test_machines.h"
#include "tests/support/vector_unit.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>

using namespace hexapose;
using namespace hexapose::testing;

namespace {

TrainingSpec setSpec(int set, int degree, std::int64_t samples = 100000) {
    return {degree, metresFromMm(setRange(set)), radiansFromDeg(setRange(set)), samples, 1};
}

std::string complaintOf(const PlatformGeometry& machine, const TrainingSpec& spec) {
    try {
        trainModel(machine, spec);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST(PolynomialBasis, HoldsEveryMonomialOnce) {
    const int counts[] = {7, 28, 84, 210};
    const double primes[] = {2, 3, 5, 7, 11, 13};
    for (int degree = kMinDegree; degree <= kMaxDegree; ++degree) {
        EXPECT_EQ(monomialCount(degree), counts[degree - 1]);
        std::vector<double> values{1.0};
        values.resize(static_cast<std::size_t>(monomialCount(degree)), 0.0);
        forEachMonomialRun(degree, [&](int variable, int parent, int child, int count) {
            for (int i = 0; i < count; ++i) {
                ASSERT_LT(parent + i, child);
                values[static_cast<std::size_t>(child + i)] =
                    primes[variable] * values[static_cast<std::size_t>(parent + i)];
            }
        });
        // Products of primes are different exactly when the monomials are.
        EXPECT_EQ(std::set<double>(values.begin(), values.end()).size(), values.size());
        EXPECT_FALSE(std::set<double>(values.begin(), values.end()).contains(0.0));
        EXPECT_EQ(values.back(), std::pow(13.0, degree));
    }
}

TEST(PolynomialModel, IsTheSumOfItsMonomialsOnEveryVectorUnit) {
    constexpr double kSame = 1e-12; // of the range of each coordinate
    const PlatformGeometry machine = laboratory();
    for (int degree = kMinDegree; degree <= kMaxDegree; ++degree) {
        const auto model = trainModel(machine, setSpec(2, degree, 1000));
        RandomPoses poses = publishedPoses(2, 60);
        for (int i = 0; i < 20; ++i) {
            const LegLengths lengths = legLengths(machine, poses.next());
            const LegVector u = (lengths - model->lengthCentre).cwiseQuotient(model->lengthScale);
            Eigen::VectorXd monomials(monomialCount(degree));
            monomials[0] = 1.0;
            forEachMonomialRun(degree, [&](int variable, int parent, int child, int count) {
                monomials.segment(child, count) = u[variable] * monomials.segment(parent, count).eval();
            });
            const PoseVector sum = model->coefficients() * monomials;
            for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
                const testing_support::OnlyVectorUnit only(target);
                const PoseVector error = (model->evaluate(lengths) - sum).cwiseAbs();
                EXPECT_LT(error.head<3>().maxCoeff() / model->spec.offsetRange, kSame)
                    << degree << ' ' << hwy::TargetName(target);
                EXPECT_LT(error.tail<3>().maxCoeff() / model->spec.angleRange, kSame)
                    << degree << ' ' << hwy::TargetName(target);
            }
        }
    }
}

TEST(Training, ReproducesThePublishedRegressionErrors) {
    const PlatformGeometry machine = laboratory();
    const struct {
        int degree, set;
        double error[6]; // alpha beta gamma (rad), x y z (m), mean absolute
    } published[] = {
        {2, 1, {3.4e-4, 1.7e-4, 2.8e-4, 0.4e-4, 0.5e-4, 0.2e-4}},
        {2, 2, {2.2e-2, 1.0e-2, 1.8e-2, 0.2e-2, 0.25e-2, 0.1e-2}},
        {3, 1, {1.8e-5, 1.9e-5, 2.6e-5, 0.3e-5, 0.2e-5, 0.2e-5}},
        {3, 2, {5.1e-3, 3.5e-3, 6.4e-3, 0.6e-3, 0.5e-3, 0.3e-3}},
    };
    for (const auto& row : published) {
        const auto model = trainModel(machine, setSpec(row.set, row.degree));
        const PoseVector error = testModel(machine, *model, 10000, 8).meanAbsolute;
        for (int k = 0; k < 6; ++k)
            EXPECT_NEAR(error[(k + 3) % 6] / row.error[k], 1.0, 0.25)
                << row.degree << ' ' << row.set << ' ' << k;
    }
}

TEST(Training, FitsAsWellAsAnyPolynomialCan) {
    // The normal equations say so: the residuals are orthogonal to every monomial.
    const PlatformGeometry machine = octahedral();
    for (int degree = kMinDegree; degree <= kMaxDegree; ++degree) {
        TrainingSpec spec = defaultTrainingSpec(machine, degree);
        spec.samples = 5000;
        const double error =
            testModel(machine, *trainModel(machine, spec), 2000, 3).meanAbsolute.tail<3>().mean();
        spec.samples = 40000;
        const double more =
            testModel(machine, *trainModel(machine, spec), 2000, 3).meanAbsolute.tail<3>().mean();
        EXPECT_LT(more, 1.05 * error) << degree;
        EXPECT_GT(more, 0.5 * error) << degree;
    }
}

TEST(Training, DependsOnTheSpecificationAlone) {
    const PlatformGeometry machine = laboratory();
    TrainingSpec spec = setSpec(2, 3, 10007);
    const auto one = trainModel(machine, spec, {}, 1), three = trainModel(machine, spec, {}, 3);
    EXPECT_EQ(one->coefficients(), three->coefficients());
    EXPECT_EQ(one->maxResidual, three->maxResidual);
    EXPECT_EQ(one->fingerprint(), three->fingerprint());
    spec.seed = 2;
    EXPECT_NE(trainModel(machine, spec)->fingerprint(), one->fingerprint());
}

TEST(Training, ReportsFromTheCallingThreadAndCanBeCancelled) {
    const PlatformGeometry machine = laboratory();
    const std::thread::id caller = std::this_thread::get_id();
    double last = 0.0;
    const auto model = trainModel(machine, setSpec(1, 2, 20000), [&](double part) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_GE(part, last);
        last = part;
        return true;
    });
    EXPECT_TRUE(model.has_value());
    EXPECT_EQ(last, 1.0);
    EXPECT_FALSE(trainModel(machine, setSpec(1, 2, 1000000000000), [](double) { return false; }).has_value());
}

TEST(Training, RefusesWhatCannotBeFitted) {
    const PlatformGeometry machine = laboratory();
    TrainingSpec spec = setSpec(1, 5);
    EXPECT_EQ(complaintOf(machine, spec), "training: degree 5 is not one of 1 to 4");
    spec = setSpec(1, 3, 83);
    EXPECT_EQ(complaintOf(machine, spec), "training: 83 samples are fewer than the 84 monomials of degree 3");
    spec = setSpec(1, 3);
    spec.offsetRange = 0.0;
    EXPECT_EQ(complaintOf(machine, spec), "training: the displacement range 0 m is not positive and finite");
    spec.offsetRange = 0.01;
    spec.angleRange = std::nan("");
    EXPECT_EQ(complaintOf(machine, spec), "training: the angle range nan rad is not positive and finite");
    EXPECT_EQ(complaintOf(similarHexagons(), setSpec(1, 3)), "training: the geometry is singular at home");
    EXPECT_THROW(defaultTrainingSpec(similarHexagons(), 3), InputError);
}

TEST(Training, ChoosesItsRangeByTheMachine) {
    const TrainingSpec published = defaultTrainingSpec(laboratory(), 3);
    EXPECT_EQ(published.offsetRange, metresFromMm(40.0));
    EXPECT_EQ(published.angleRange, radiansFromDeg(40.0));
    EXPECT_NEAR(defaultTrainingSpec(scaledBy(1e6, laboratory()), 3).offsetRange, 4e4, 1e-9);
    PlatformGeometry flat = laboratory(); // nearly in one plane: singularities are close
    flat.p_OP_home_B[2] = 0.1;
    EXPECT_LT(defaultTrainingSpec(flat, 3).angleRange, radiansFromDeg(40.0));
}

TEST(Training, TakesTheMachinesOwnRangeWhereNoneIsGiven) {
    for (const PlatformGeometry& machine : {laboratory(), scaledBy(1e-3, laboratory())}) {
        const auto model = trainModel(machine, TrainingSpec{.samples = 2000});
        ASSERT_TRUE(model);
        EXPECT_EQ(model->spec.offsetRange, defaultTrainingSpec(machine, 3).offsetRange);
        EXPECT_EQ(model->spec.angleRange, defaultTrainingSpec(machine, 3).angleRange);
    }
}

TEST(MprNewton, SolvesThePhysicalTestOfThePaper) {
    const PlatformGeometry machine = laboratory();
    const LegLengths lengths = metres(339.5, 336.5, 336.6, 329.2, 345.1, 334.5);
    for (const char* word : {"newton", "newton-as-published", "mpr2-nr", "mpr3-nr"}) {
        const ForwardMethod& method = *findForwardMethod(word);
        std::optional<PolynomialModel> model;
        if (method.modelDegree != 0)
            model = trainModel(machine, defaultTrainingSpec(machine, method.modelDegree));
        const auto solver = makeForwardSolver(method, machine, model ? &*model : nullptr, {});
        const ForwardResult result = solver->solve(lengths, Pose{});
        EXPECT_EQ(result.status, SolveStatus::Converged) << word;
        EXPECT_NEAR(result.pose.angles.alpha, -1.686e-4, 0.5e-7);
        EXPECT_NEAR(result.pose.angles.beta, 5.838e-5, 0.5e-8);
        EXPECT_NEAR(result.pose.angles.gamma, 0.08689, 0.5e-5);
        EXPECT_NEAR(result.pose.offset[0], 0.01199, 0.5e-5);
        EXPECT_NEAR(result.pose.offset[1], -0.00404, 0.5e-5);
        EXPECT_NEAR(result.pose.offset[2], 0.03978, 0.5e-5);
    }
}

TEST(MprNewton, SavesIterations) {
    const PlatformGeometry machine = laboratory();
    const MprNewton mpr(machine, *trainModel(machine, setSpec(2, 3)), {});
    RandomPoses poses = publishedPoses(2, 51);
    int iterations = 0;
    for (int i = 0; i < 2000; ++i) {
        const ForwardResult result = mpr.solve(legLengths(machine, poses.next()), Pose{});
        ASSERT_EQ(result.status, SolveStatus::Converged);
        iterations += result.iterations;
    }
    EXPECT_LT(iterations / 2000.0, 2.7); // 4.3 from home
}

TEST(MprNewton, SaysOutsideModelAndStillSolves) {
    const PlatformGeometry machine = laboratory();
    const PolynomialModel model = *trainModel(machine, setSpec(1, 3, 20000)); // +-10 mm, +-10 deg only
    const MprNewton mpr(machine, model, {});
    const PolynomialRegression regression(machine, model);
    RandomPoses poses = publishedPoses(2, 52);
    int outside = 0;
    for (int i = 0; i < 500; ++i) {
        const Pose truth = poses.next();
        const PoseVector v = truth.toVector().cwiseAbs();
        const bool inside = v.head<3>().maxCoeff() <= 0.01 && v.tail<3>().maxCoeff() <= radiansFromDeg(10.0);
        const bool far = v.head<3>().maxCoeff() > 0.012 || v.tail<3>().maxCoeff() > radiansFromDeg(12.0);
        const LegLengths lengths = legLengths(machine, truth);
        const ForwardResult result = mpr.solve(lengths, Pose{});
        EXPECT_TRUE(result.isUsable() && result.accurate);
        EXPECT_LT(distance(machine, result.pose, truth), 1e-7);
        if (inside || far) {
            EXPECT_EQ(result.status, inside ? SolveStatus::Converged : SolveStatus::OutsideModel);
            EXPECT_EQ(regression.solve(lengths, Pose{}).status, result.status);
        }
        outside += result.status == SolveStatus::OutsideModel ? 1 : 0;
    }
    EXPECT_GT(outside, 400);
    // Within the model's range, whatever the tolerance.
    const MprNewton exacting(machine, model, {1e-30, 50});
    const ForwardResult within =
        exacting.solve(legLengths(machine, Pose{{0.003, 0.002, -0.004}, {}}), Pose{});
    EXPECT_TRUE(within.status == SolveStatus::IterationLimit || within.status == SolveStatus::Converged)
        << toWord(within.status);
    // What Newton says passes through.
    EXPECT_EQ(mpr.solve(metres(400, 320, 400, 320, 400, 320), Pose{}).status, SolveStatus::NoSolution);
    const Pose beyond{{}, {0.0, 0.0, radiansFromDeg(120.0)}};
    const ForwardResult twin = mpr.solve(legLengths(machine, beyond), beyond);
    EXPECT_TRUE(twin.status == SolveStatus::OtherBranch || distance(machine, twin.pose, beyond) > 0.1);
}

TEST(ForwardMethods, NeedTheRightModel) {
    const PlatformGeometry machine = laboratory();
    const PolynomialModel model = *trainModel(machine, setSpec(1, 2, 1000));
    const auto complaint = [&](const char* word, const PlatformGeometry& geometry,
                               const PolynomialModel* given) {
        try {
            makeForwardSolver(*findForwardMethod(word), geometry, given, {});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_EQ(complaint("mpr2-nr", machine, &model), "accepted");
    EXPECT_EQ(complaint("mpr3-nr", machine, nullptr), "method mpr3-nr: needs a regression model of degree 3");
    EXPECT_EQ(complaint("mpr3", machine, &model),
              "method mpr3: needs a regression model of degree 3, this one has degree 2");
    EXPECT_EQ(complaint("mpr2", octahedral(), &model), "method mpr2: the model belongs to platform " +
                                                           machine.fingerprint() + ", this platform is " +
                                                           octahedral().fingerprint());
    EXPECT_EQ(findForwardMethod("mpr9"), nullptr);
}
