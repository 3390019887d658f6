// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Compiled once for each kind of vector unit; the one for this processor is chosen when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kinematics/vector/newton_lanes.cpp"
#include "core/kinematics/vector/newton_lanes.h"
#include "core/kinematics/vector/lane_targets.h"

#include <hwy/foreach_target.h>
// The targets first.
#include "core/kinematics/vector/lane_angles.h"
#include "core/kinematics/vector/lane_legs.h"
#include "core/kinematics/vector/lane_newton.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace hexapose {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Many = hn::CappedTag<double, LaneBlock::kMostLanes>;

/// Place and rotation of a pose: offset, then sines and cosines of the half angles.
template <class N, class V = typename N::V>
HWY_INLINE void place(const LaneMachine& machine, const V* offset, const V* s, const V* c,
                      typename N::Run& run) {
    const V cc = hn::Mul(c[2], c[1]), ss = hn::Mul(s[2], s[1]), cs = hn::Mul(c[2], s[1]),
            sc = hn::Mul(s[2], c[1]);
    run.place.q[0] = hn::MulAdd(cc, c[0], hn::Mul(ss, s[0]));
    run.place.q[1] = N::minor(cc, s[0], ss, c[0]);
    run.place.q[2] = hn::MulAdd(cs, c[0], hn::Mul(sc, s[0]));
    run.place.q[3] = N::minor(sc, c[0], cs, s[0]);
    run.rotation = N::rotation(run.place.q);
    for (std::size_t k = 0; k < 3; ++k)
        run.place.c[k] = hn::Add(
            hn::MulAdd(offset[k], N::set(1.0 / machine.size), N::set(machine.homeOrigin[k])),
            N::dot3(run.rotation.r[k][0], N::set(machine.centroidInP[0]), run.rotation.r[k][1],
                    N::set(machine.centroidInP[1]), run.rotation.r[k][2], N::set(machine.centroidInP[2])));
}

template <class N>
HWY_INLINE void placeAtHome(const LaneMachine& machine, typename N::Run& run) {
    for (std::size_t k = 0; k < 3; ++k)
        run.place.c[k] = N::set(machine.homeOrigin[k] + machine.centroidInP[k]);
    for (int k = 0; k < 4; ++k)
        run.place.q[k] = N::set(k == 0 ? 1.0 : 0.0);
    run.rotation = N::rotation(run.place.q);
}

void solveOne(const LaneMachine& machine, const LegLengths& lengths, const Pose& start, double tolerance,
              int maxIterations, LaneSolution& solution) {
    using N = Newton<OnePose>;
    const EulerAngles& angles = start.angles;
    const bool fromHome = start.offset[0] == 0.0 && start.offset[1] == 0.0 && start.offset[2] == 0.0 &&
                          angles.alpha == 0.0 && angles.beta == 0.0 && angles.gamma == 0.0;
    N::Run run;
    if (fromHome) {
        placeAtHome<N>(machine, run);
    } else {
        const N::V offset[] = {N::set(start.offset[0]), N::set(start.offset[1]), N::set(start.offset[2])};
        N::V s[3], c[3];
        N::sinCosOfHalves(angles, s, c);
        place<N>(machine, offset, s, c, run);
    }
    const N::Limits limits{tolerance * (1.0 / machine.size), std::min(maxIterations, kMostSteps)};
    if (N::begin(machine, N::lengthsOf(machine, lengths), fromHome, limits, run))
        while (N::advance(machine, limits, run)) {
        }

    const N::Found found = N::found(machine, run.place, run.rotation);
    N::store(found, solution.pose);
    solution.solved = hn::AllTrue(N::D(), run.solved);
    solution.certified = hn::AllTrue(N::D(), N::clear(machine, run, found));
    solution.residual = hn::GetLane(hn::Sqrt(run.residual2)) * machine.size;
    solution.startResidual = hn::GetLane(hn::Sqrt(run.startResidual2)) * machine.size;
    solution.iterations = run.steps;
    if (solution.certified)
        return;
    for (std::size_t k = 0; k < 3; ++k)
        solution.centroid[k] = hn::GetLane(run.place.c[k]) + machine.baseCentroid[k];
    for (std::size_t k = 0; k < 4; ++k)
        solution.rotation[k] = hn::GetLane(run.place.q[k]);
}

std::size_t countLanes() {
    return hn::Lanes(Many());
}

/// Rows of six numbers, one a lane: where each lane's begins, from the first one's. Lanes without a row of
/// their own repeat the last one.
HWY_INLINE auto rowOffsets(std::size_t count) {
    using Index = hn::RebindToSigned<Many>;
    const auto row = hn::Min(hn::Iota(Index(), 0), hn::Set(Index(), static_cast<std::int64_t>(count) - 1));
    return hn::Add(hn::ShiftLeft<2>(row), hn::ShiftLeft<1>(row));
}

using Batch = Newton<LaneSteps<Many>>;

/// Poses of a batch, one a lane, and which block of results they are.
struct Group {
    Batch::Run run;
    std::size_t block;
    bool open = false;
};

/// False: no step is wanted.
HWY_INLINE bool open(const LaneMachine& machine, const LegLengths* lengths, std::size_t count,
                     const Batch::Limits& limits, Group& group) {
    using N = Batch;
    const std::size_t first = group.block * hn::Lanes(Many());
    const auto offset = rowOffsets(count - first);
    N::Lengths rows;
    for (std::size_t i = 0; i < kLegCount; ++i)
        rows.l[i] = hn::Mul(hn::GatherIndex(Many(), lengths[first].data() + machine.order[i], offset),
                            N::set(1.0 / machine.size));
    placeAtHome<N>(machine, group.run);
    return N::begin(machine, rows, true, limits, group.run);
}

HWY_INLINE void close(const LaneMachine& machine, const Batch::Run& run, LaneBlock& block) {
    using N = Batch;
    const N::Found found = N::found(machine, run.place, run.rotation);
    for (std::size_t k = 0; k < 6; ++k)
        hn::Store(found.pose[k], Many(), block.pose[k].data());
    hn::Store(hn::Mul(hn::Sqrt(run.residual2), N::set(machine.size)), Many(), block.residual.data());
    hn::Store(run.iterations, Many(), block.iterations.data());
    alignas(64) LaneBlock::Lanes flags;
    hn::Store(hn::IfThenElseZero(N::clear(machine, run, found), N::set(1.0)), Many(), flags.data());
    for (std::size_t i = 0; i < hn::Lanes(Many()); ++i)
        block.certified[i] = flags[i] != 0.0;
}

/// Two groups take their steps in turn: what one waits for, the other fills.
void solveMany(const LaneMachine& machine, const LegLengths* lengths, std::size_t count, double tolerance,
               int maxIterations, LaneBlock* blocks) {
    const Batch::Limits limits{tolerance * (1.0 / machine.size), std::min(maxIterations, kMostSteps)};
    const std::size_t all = (count + hn::Lanes(Many()) - 1) / hn::Lanes(Many());
    std::size_t begun = 0, closed = 0;
    Group groups[2];
    while (closed < all)
        for (Group& group : groups) {
            bool goesOn = false;
            if (group.open) {
                goesOn = Batch::advance(machine, limits, group.run);
            } else if (begun < all) {
                group.block = begun++;
                goesOn = open(machine, lengths, count, limits, group);
                group.open = true;
            }
            if (group.open && !goesOn) {
                close(machine, group.run, blocks[group.block]);
                group.open = false;
                ++closed;
            }
        }
}

void determinants(const LaneMachine& machine, const PoseVector& end, std::size_t count, double* values) {
    using N = Batch;
    for (std::size_t first = 0; first < count; first += hn::Lanes(Many())) {
        const N::V part = hn::Mul(hn::Iota(Many(), static_cast<double>(first + 1)),
                                  N::set(1.0 / static_cast<double>(count)));
        N::V offsets[3], sines[3], cosines[3];
        for (int k = 0; k < 3; ++k) {
            offsets[k] = hn::Mul(part, N::set(end[k]));
            shortSinCos(Many(), hn::Mul(part, N::set(0.5 * end[3 + k])), sines[k], cosines[k]);
        }
        N::Run run;
        place<N>(machine, offsets, sines, cosines, run);
        N::V product = N::set(1.0);
        N::Lengths lengths;
        for (N::V& length : lengths.l)
            length = N::set(1.0); // of no consequence here
        N::Rows rows;
        N::evaluate(machine, run.place, run.rotation, N::target(lengths), rows);
        N::moments(machine, rows);
        for (int i = 0; i < kLegCount; ++i)
            product = hn::Mul(product, N::dot3(rows.d[0][i], rows.d[0][i], rows.d[1][i], rows.d[1][i],
                                               rows.d[2][i], rows.d[2][i]));
        const N::V determinant =
            hn::Mul(N::solve(rows, run.place).determinant, N::set(machine.determinantScale));
        alignas(64) LaneBlock::Lanes found;
        hn::Store(hn::Div(determinant, hn::Sqrt(product)), Many(), found.data());
        std::copy_n(found.begin(), std::min(count - first, hn::Lanes(Many())), values + first);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace hexapose
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hexapose {

HWY_EXPORT(solveOne);
HWY_EXPORT(countLanes);
HWY_EXPORT(solveMany);
HWY_EXPORT(determinants);

void solveLane(const LaneMachine& machine, const LegLengths& lengths, const Pose& start, double tolerance,
               int maxIterations, LaneSolution& solution) noexcept {
    HWY_DYNAMIC_DISPATCH(solveOne)(machine, lengths, start, tolerance, maxIterations, solution);
}

std::size_t laneCount() noexcept {
    return HWY_DYNAMIC_DISPATCH(countLanes)();
}

void solveLanes(const LaneMachine& machine, const LegLengths* lengths, std::size_t count, double tolerance,
                int maxIterations, LaneBlock* blocks) noexcept {
    HWY_DYNAMIC_DISPATCH(solveMany)(machine, lengths, count, tolerance, maxIterations, blocks);
}

void laneDeterminants(const LaneMachine& machine, const PoseVector& end, std::size_t count,
                      double* values) noexcept {
    HWY_DYNAMIC_DISPATCH(determinants)(machine, end, count, values);
}

} // namespace hexapose
#endif
