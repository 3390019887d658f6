// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// What the vector unit can do at best: independent multiplications and additions, nothing to wait for.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/fma_peak.cpp"
#include "tests/bench/fma_peak.h"
#include "core/kinematics/vector/lane_targets.h"

#include <hwy/foreach_target.h>
// The targets first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hexapose::bench {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

double multiplyAdd(long rounds) {
    const hn::ScalableTag<double> d;
    const auto factor = hn::Set(d, 0.999), term = hn::Set(d, 0.001);
    auto a = hn::Iota(d, 0.0), b = hn::Iota(d, 0.1), c = hn::Iota(d, 0.2), e = hn::Iota(d, 0.3);
    auto f = hn::Iota(d, 0.4), g = hn::Iota(d, 0.5), h = hn::Iota(d, 0.6), i = hn::Iota(d, 0.7);
    auto j = hn::Iota(d, 0.8), k = hn::Iota(d, 0.9);
    for (long round = 0; round < rounds; ++round) {
        a = hn::MulAdd(a, factor, term);
        b = hn::MulAdd(b, factor, term);
        c = hn::MulAdd(c, factor, term);
        e = hn::MulAdd(e, factor, term);
        f = hn::MulAdd(f, factor, term);
        g = hn::MulAdd(g, factor, term);
        h = hn::MulAdd(h, factor, term);
        i = hn::MulAdd(i, factor, term);
        j = hn::MulAdd(j, factor, term);
        k = hn::MulAdd(k, factor, term);
    }
    const auto sum = hn::Add(hn::Add(hn::Add(a, b), hn::Add(c, e)),
                             hn::Add(hn::Add(hn::Add(f, g), hn::Add(h, i)), hn::Add(j, k)));
    return hn::GetLane(sum);
}

double flopsARound() {
    return 10.0 * 2.0 * static_cast<double>(hn::Lanes(hn::ScalableTag<double>()));
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace hexapose::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hexapose::bench {

HWY_EXPORT(multiplyAdd);
HWY_EXPORT(flopsARound);

double multiplyAdds(long rounds) {
    return HWY_DYNAMIC_DISPATCH(multiplyAdd)(rounds);
}
double multiplyAddFlops(long rounds) {
    return HWY_DYNAMIC_DISPATCH(flopsARound)() * static_cast<double>(rounds);
}

} // namespace hexapose::bench
#endif
