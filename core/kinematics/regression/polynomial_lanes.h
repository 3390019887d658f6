// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hexapose {

/// Six polynomials in six variables at once, on the processor's vector unit. coefficients: eight numbers a
/// monomial, aligned to 64 bytes, of which the last two are not used; monomials in the order of
/// polynomial_basis.h up to `degree` (1 to 4). values: six.
void evaluatePolynomials(int degree, const double* variables, const double* coefficients,
                         double* values) noexcept;

} // namespace hexapose
