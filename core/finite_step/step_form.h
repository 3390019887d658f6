// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace hexapose {

/// What a step asks for. Open, as the paper: the actuators' step, errors add up, order 1. Closed: also what
/// the constraints miss, at the same cost, order 2. Corrected: closed, and one Newton correction, order 4.
enum class StepForm : std::uint8_t { Open, Closed, Corrected };

/// "open", "closed", "corrected".
constexpr std::string_view toWord(StepForm form) noexcept {
    return form == StepForm::Open ? "open" : form == StepForm::Closed ? "closed" : "corrected";
}
constexpr std::optional<StepForm> stepFormFromWord(std::string_view word) noexcept {
    for (const StepForm form : {StepForm::Open, StepForm::Closed, StepForm::Corrected})
        if (toWord(form) == word)
            return form;
    return std::nullopt;
}

} // namespace hexapose
