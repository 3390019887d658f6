// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// The different words of a column, by their codes; 0 is the empty word. It only grows, and a copy shares
/// the words.
class WordList {
public:
    std::string_view at(std::uint32_t code) const {
        return code == 0 ? std::string_view()
                         : std::string_view((*m_pages[(code - 1) / kPage])[(code - 1) % kPage]);
    }
    std::uint32_t count() const { return m_count; } ///< without the empty one
    /// The code of a further word.
    std::uint32_t append(std::string word) {
        if (m_count % kPage == 0)
            m_pages.push_back(std::make_shared<std::array<std::string, kPage>>());
        (*m_pages.back())[m_count % kPage] = std::move(word);
        return ++m_count;
    }

private:
    static constexpr std::size_t kPage = 256;
    std::vector<std::shared_ptr<std::array<std::string, kPage>>> m_pages;
    std::uint32_t m_count = 0;
};

} // namespace hexapose
