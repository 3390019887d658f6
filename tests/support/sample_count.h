// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hexapose::testing_support {

/// How many of `all` random cases a test looks at: all of them in an ordinary build, some under a sanitizer,
/// which looks for another kind of mistake and takes thirty times as long.
constexpr int samples(int all) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return all / 20;
#else
    return all;
#endif
}

} // namespace hexapose::testing_support
