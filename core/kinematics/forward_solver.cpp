// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/forward_solver.h"

#include <array>
#include <utility>

namespace hexapose {

namespace {

constexpr std::array<std::pair<SolveStatus, std::string_view>, 7> kWords{{
    {SolveStatus::Converged, "converged"},
    {SolveStatus::IterationLimit, "iteration-limit"},
    {SolveStatus::Singular, "singular"},
    {SolveStatus::NoSolution, "no-solution"},
    {SolveStatus::InvalidInput, "invalid-input"},
    {SolveStatus::OutsideModel, "outside-model"},
    {SolveStatus::OtherBranch, "other-branch"},
}};

} // namespace

std::string_view toWord(SolveStatus status) {
    for (const auto& [value, word] : kWords)
        if (value == status)
            return word;
    return "unknown";
}

std::optional<SolveStatus> solveStatusFromWord(std::string_view word) {
    for (const auto& [value, text] : kWords)
        if (text == word)
            return value;
    return std::nullopt;
}

bool ForwardResult::hasPose() const {
    if (status == SolveStatus::OutsideModel)
        return accurate; // a polynomial means nothing outside what it was fitted to
    return status != SolveStatus::InvalidInput && status != SolveStatus::NoSolution && pose.isFinite();
}

} // namespace hexapose
