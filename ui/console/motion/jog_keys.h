// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt>

#include <optional>
#include <utility>

namespace hexapose {

/// The axis (0..5) and direction (true: plus) that a key means for a jog: left and right x, down and up y,
/// page down and page up z; with Shift about these axes. Nothing for another key.
inline std::optional<std::pair<int, bool>> jogKey(int key, Qt::KeyboardModifiers modifiers) {
    constexpr std::pair<int, std::pair<int, bool>> kKeys[] = {
        {Qt::Key_Left, {0, false}}, {Qt::Key_Right, {0, true}},     {Qt::Key_Down, {1, false}},
        {Qt::Key_Up, {1, true}},    {Qt::Key_PageDown, {2, false}}, {Qt::Key_PageUp, {2, true}}};
    if (modifiers & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) {
        return std::nullopt;
    }
    const int turn = modifiers & Qt::ShiftModifier ? 3 : 0;
    for (const auto& [known, jog] : kKeys) {
        if (known == key) {
            return std::pair(jog.first + turn, jog.second);
        }
    }
    return std::nullopt;
}

} // namespace hexapose
