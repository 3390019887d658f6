// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Compiled once for each kind of vector unit; the one for this processor is chosen when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kinematics/newton_lanes.cpp"
#include "core/kinematics/newton_lanes.h"
#include "core/kinematics/lane_targets.h"

#include <hwy/foreach_target.h>
// The targets first.
#include "core/kinematics/lane_angles.h"
#include "core/kinematics/lane_newton.h"

#include <hwy/contrib/math/math-inl.h>
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
template <class D, class V = hn::Vec<D>>
HWY_INLINE void place(const LaneMachine& machine, const V* offset, const V* s, const V* c,
                      typename Newton<D>::Run& run) {
    using N = Newton<D>;
    const V cc = hn::Mul(c[2], c[1]), ss = hn::Mul(s[2], s[1]), cs = hn::Mul(c[2], s[1]),
            sc = hn::Mul(s[2], c[1]);
    run.place.q[0] = hn::MulAdd(cc, c[0], hn::Mul(ss, s[0]));
    run.place.q[1] = N::Steps::minor(cc, s[0], ss, c[0]);
    run.place.q[2] = hn::MulAdd(cs, c[0], hn::Mul(sc, s[0]));
    run.place.q[3] = N::Steps::minor(sc, c[0], cs, s[0]);
    run.rotation = N::rotation(run.place.q);
    for (std::size_t k = 0; k < 3; ++k)
        run.place.c[k] = hn::Add(
            hn::MulAdd(offset[k], N::set(1.0 / machine.size), N::set(machine.homeOrigin[k])),
            N::dot3(run.rotation.r[k][0], N::set(machine.centroidInP[0]), run.rotation.r[k][1],
                    N::set(machine.centroidInP[1]), run.rotation.r[k][2], N::set(machine.centroidInP[2])));
}

HWY_INLINE void placeAt(const LaneMachine& machine, const PoseVector& pose, Newton<One>::Run& run) {
    using N = Newton<One>;
    const auto half = [&pose](int k) HWY_ATTR { return N::set(0.5 * pose[3 + k]); };
    N::V s[3], c[3];
    const bool isShort =
        std::max({std::abs(pose[3]), std::abs(pose[4]), std::abs(pose[5])}) <= 2.0 * kShortAngle;
    if (HWY_LIKELY(isShort && kHasPairs)) {
        hn::Vec<Two> sines, cosines;
        shortSinCos(Two(), pairOf(half(0), half(1)), sines, cosines);
        s[0] = firstOf(sines);
        s[1] = secondOf(sines);
        c[0] = firstOf(cosines);
        c[1] = secondOf(cosines);
        shortSinCos(One(), half(2), s[2], c[2]);
    } else {
        for (int k = 0; k < 3; ++k) {
            s[k] = hn::Sin(One(), half(k));
            c[k] = hn::Cos(One(), half(k));
        }
    }
    const N::V offset[] = {N::set(pose[0]), N::set(pose[1]), N::set(pose[2])};
    place<One>(machine, offset, s, c, run);
}

template <class D>
HWY_INLINE void placeAtHome(const LaneMachine& machine, typename Newton<D>::Run& run) {
    for (std::size_t k = 0; k < 3; ++k)
        run.place.c[k] = hn::Set(D(), machine.homeOrigin[k] + machine.centroidInP[k]);
    for (int k = 0; k < 4; ++k)
        run.place.q[k] = hn::Set(D(), k == 0 ? 1.0 : 0.0);
    run.rotation = Newton<D>::rotation(run.place.q);
}

void solveOne(const LaneMachine& machine, const LegLengths& lengths, const PoseVector& start,
              double tolerance, int maxIterations, LaneSolution& solution) {
    using N = Newton<One>;
    const bool fromHome = (start.array() == 0.0).all();
    N::V l[kLegCount];
    const double toSizes = 1.0 / machine.size;
    for (std::size_t i = 0; i < kLegCount; ++i)
        l[i] = N::set(lengths[machine.order[i]] * toSizes);
    N::Run run;
    if (fromHome)
        placeAtHome<One>(machine, run);
    else
        placeAt(machine, start, run);
    const N::Limits limits{tolerance * toSizes, std::min(maxIterations, kMostSteps)};
    if (N::begin(machine, l, fromHome, limits, run))
        while (N::advance(machine, limits, run)) {
        }

    N::V pose[6], cosBeta2;
    N::toPose(machine, run, pose, cosBeta2);
    solution.solved = hn::AllTrue(One(), run.solved);
    solution.clear = hn::AllTrue(One(), N::clear(machine, run, cosBeta2, pose));
    for (int k = 0; k < 6; ++k)
        solution.pose[k] = hn::GetLane(pose[k]);
    for (std::size_t k = 0; k < 3; ++k)
        solution.centroid[k] = hn::GetLane(run.place.c[k]) + machine.baseCentroid[k];
    for (std::size_t k = 0; k < 4; ++k)
        solution.rotation[k] = hn::GetLane(run.place.q[k]);
    solution.residual = hn::GetLane(hn::Sqrt(run.residual2)) * machine.size;
    solution.startResidual = hn::GetLane(hn::Sqrt(run.startResidual2)) * machine.size;
    solution.iterations = static_cast<int>(hn::GetLane(run.iterations));
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

/// Poses of a batch, one a lane, and which block of results they are.
struct Group {
    Newton<Many>::Run run;
    std::size_t block;
    bool open = false;
};

/// False: no step is wanted.
HWY_INLINE bool open(const LaneMachine& machine, const LegLengths* lengths, std::size_t count,
                     const Newton<Many>::Limits& limits, Group& group) {
    using N = Newton<Many>;
    const std::size_t first = group.block * hn::Lanes(Many());
    const auto offset = rowOffsets(count - first);
    N::V l[kLegCount];
    for (std::size_t i = 0; i < kLegCount; ++i)
        l[i] = hn::Mul(hn::GatherIndex(Many(), lengths[first].data() + machine.order[i], offset),
                       N::set(1.0 / machine.size));
    placeAtHome<Many>(machine, group.run);
    return N::begin(machine, l, true, limits, group.run);
}

HWY_INLINE void close(const LaneMachine& machine, const Newton<Many>::Run& run, LaneBlock& block) {
    using N = Newton<Many>;
    N::V pose[6], cosBeta2;
    N::toPose(machine, run, pose, cosBeta2);
    for (std::size_t k = 0; k < 6; ++k)
        hn::Store(pose[k], Many(), block.pose[k].data());
    hn::Store(hn::Mul(hn::Sqrt(run.residual2), N::set(machine.size)), Many(), block.residual.data());
    hn::Store(run.iterations, Many(), block.iterations.data());
    alignas(64) LaneBlock::Lanes flags;
    hn::Store(hn::IfThenElseZero(N::clear(machine, run, cosBeta2, pose), N::set(1.0)), Many(), flags.data());
    for (std::size_t i = 0; i < hn::Lanes(Many()); ++i)
        block.clear[i] = flags[i] != 0.0;
}

/// Two groups take their steps in turn: what one waits for, the other fills.
void solveMany(const LaneMachine& machine, const LegLengths* lengths, std::size_t count, double tolerance,
               int maxIterations, LaneBlock* blocks) {
    const Newton<Many>::Limits limits{tolerance * (1.0 / machine.size), std::min(maxIterations, kMostSteps)};
    const std::size_t all = (count + hn::Lanes(Many()) - 1) / hn::Lanes(Many());
    std::size_t begun = 0, closed = 0;
    Group groups[2];
    while (closed < all)
        for (Group& group : groups) {
            bool goesOn = false;
            if (group.open) {
                goesOn = Newton<Many>::advance(machine, limits, group.run);
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
    using N = Newton<Many>;
    for (std::size_t first = 0; first < count; first += hn::Lanes(Many())) {
        const N::V part = hn::Mul(hn::Iota(Many(), static_cast<double>(first + 1)),
                                  N::set(1.0 / static_cast<double>(count)));
        N::V offsets[3], sines[3], cosines[3];
        for (int k = 0; k < 3; ++k) {
            offsets[k] = hn::Mul(part, N::set(end[k]));
            shortSinCos(Many(), hn::Mul(part, N::set(0.5 * end[3 + k])), sines[k], cosines[k]);
        }
        N::Run run;
        place<Many>(machine, offsets, sines, cosines, run);
        N::V l[kLegCount], product = N::set(1.0);
        for (N::V& length : l)
            length = N::set(1.0); // of no consequence here
        N::Rows rows;
        N::evaluate(machine, run.place, run.rotation, N::target(l), rows);
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

void solveLane(const LaneMachine& machine, const LegLengths& lengths, const PoseVector& start,
               double tolerance, int maxIterations, LaneSolution& solution) noexcept {
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
