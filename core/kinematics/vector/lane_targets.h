// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// To be included before anything of Highway. Of the vector units of x86-64, those that differ for this work:
// without fused multiplication, with it, and with 512 bits; fewer mean less to compile. On other processors
// the one that the compiler targets: GCC cannot compile structures of vectors for several in one file
// there. None whose length is known only when the program runs, for these cannot be members.
#pragma once

#define HWY_DISABLED_TARGETS                                                                                 \
    (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

#if !defined(__x86_64__) && !defined(__i386__)
#define HWY_COMPILE_ONLY_STATIC
#endif
