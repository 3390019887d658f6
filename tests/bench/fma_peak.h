// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hexapose::bench {

/// Vector multiplications with addition that do not depend on each other; the result only keeps them from
/// vanishing.
double multiplyAdds(long rounds);
/// Floating-point operations of so many rounds.
double multiplyAddFlops(long rounds);

} // namespace hexapose::bench
