// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/forward_solver.h"

#include <memory>
#include <string_view>
#include <utility>

namespace hexapose {

/// What the loop solves with: another solver from one cycle to the next. Belongs to the loop's thread.
class ReplaceableSolver final : public ForwardSolver {
public:
    explicit ReplaceableSolver(std::shared_ptr<const ForwardSolver> solver) : m_solver(std::move(solver)) {}
    ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept override {
        return m_solver->solve(lengths, start);
    }
    std::string_view name() const noexcept override { return m_solver->name(); }
    void replace(std::shared_ptr<const ForwardSolver> solver) { m_solver = std::move(solver); }

private:
    std::shared_ptr<const ForwardSolver> m_solver;
};

} // namespace hexapose
