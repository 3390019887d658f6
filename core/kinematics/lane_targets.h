// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// To be included before anything of Highway. Of the vector units of x86-64, those that differ for this work:
// without fused multiplication, with it, and with 512 bits; fewer mean less to compile. Other processors take
// what they have.
#pragma once

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
