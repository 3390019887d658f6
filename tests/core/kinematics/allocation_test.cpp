// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// No solver may allocate: it runs in the control cycle. The linker sends every malloc of the libraries here.
#include "core/finite_step/finite_step_solver.h"
#include "core/finite_step/node_path.h"
#include "core/finite_step/path_fallback.h"
#include "core/kinematics/catalog/forward_methods.h"
#include "core/kinematics/regression/mpr_newton.h"
#include "test_machines.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<int> allocations = 0;

} // namespace

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_aligned_alloc(std::size_t alignment, std::size_t size);
int __real_posix_memalign(void** pointer, std::size_t alignment, std::size_t size);

void* __wrap_malloc(std::size_t size) {
    ++allocations;
    return __real_malloc(size);
}
void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
    ++allocations;
    return __real_aligned_alloc(alignment, size);
}
int __wrap_posix_memalign(void** pointer, std::size_t alignment, std::size_t size) {
    ++allocations;
    return __real_posix_memalign(pointer, alignment, size);
}
}

void* operator new(std::size_t size) {
    if (void* memory = __wrap_malloc(size))
        return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

using namespace hexapose;
using namespace hexapose::testing;

TEST(Allocation, TheCounterSeesEigenAndNew) {
    const int before = allocations;
    const Eigen::VectorXd dynamic = Eigen::VectorXd::Ones(50);
    EXPECT_GT(allocations, before);
    const int between = allocations;
    ::operator delete(
        ::operator new(static_cast<std::size_t>(dynamic.sum()))); // not elided, unlike an expression
    EXPECT_GT(allocations, between);
}

TEST(Allocation, NoSolverAllocates) {
    const PlatformGeometry machine = laboratory();
    for (const ForwardMethod& method : forwardMethods()) {
        std::optional<PolynomialModel> model;
        if (method.modelDegree != 0)
            model = trainModel(machine, {method.modelDegree, 0.02, 0.3, 2000, 1});
        const auto solver = makeForwardSolver(method, machine, model ? &*model : nullptr, {});
        RandomPoses wide(0.08, 1.3, 61), narrow(0.015, 0.2, 62); // every way through guards and fall-backs
        std::vector<LegLengths> cases(400, metres(400, 320, 400, 320, 400, 320));
        for (std::size_t i = 1; i < cases.size(); ++i)
            cases[i] = legLengths(machine, (i % 2 == 0 ? wide : narrow).next());
        cases[1][0] = std::nan("");
        const int before = allocations;
        int usable = 0;
        for (const LegLengths& lengths : cases)
            usable += solver->solve(lengths, Pose{}).isUsable() ? 1 : 0;
        EXPECT_EQ(allocations, before) << method.word;
        EXPECT_GT(usable, 0) << method.word;
    }
}

TEST(Allocation, NoFallbackAllocates) {
    const PlatformGeometry machine = laboratory();
    const auto model = trainModel(machine, {3, 0.02, 0.3, 2000, 1});
    const PathFallback solver(machine, std::make_shared<MprNewton>(machine, *model, NewtonOptions{1e-10, 2}));
    RandomPoses poses(0.08, 1.3, 61);
    const int before = allocations;
    int followed = 0, stopped = 0;
    for (int i = 0; i < 100; ++i) { // two iterations are too few for most
        const auto answer = solver.answer(legLengths(machine, poses.next()), Pose{});
        followed += answer.fromPath;
        stopped += answer.path && !answer.fromPath;
    }
    EXPECT_EQ(allocations, before);
    EXPECT_TRUE(followed > 0 && stopped > 0) << followed << " and " << stopped;
}

TEST(Allocation, NoStepAllocates) {
    const PlatformGeometry machine = laboratory();
    const StepSystem system(mechanismOf(machine), machine.name);
    const LegLengths fold = metres(400, 320, 400, 320, 400, 320);
    const StraightDrive drive(system.homeDrive(), fold);
    for (const StepForm form : {StepForm::Open, StepForm::Closed, StepForm::Corrected}) {
        const FiniteStepSolver solver(machine, {100, form, 0.0});
        NodePath path(system, drive, 100, form, system.homeNodes());
        RandomPoses poses(0.06, 1.0, 63);
        const int before = allocations;
        int usable = 0;
        for (int i = 0; i < 50; ++i)
            usable += solver.solve(legLengths(machine, poses.next()), Pose{}).isUsable() ? 1 : 0;
        usable += solver.solve(fold, Pose{}).isUsable() ? 1 : 0;
        while (path.advance()) {
        }
        EXPECT_EQ(allocations, before) << toWord(form);
        EXPECT_TRUE(usable > 0 && usable < 51 && path.isSingular());
    }
}
