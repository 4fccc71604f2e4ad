#pragma once

#include <cstdint>
#include <span>

namespace ink::core {

/// The number of ones. As fast as std::popcount where that is an instruction to the compiler, and
/// without a call where it is not (Warren 2012, "Hacker's Delight", section 5-1).
[[nodiscard]] constexpr int count_ones(std::uint64_t word) {
    word -= word >> 1 & 0x5555555555555555U;
    word = (word & 0x3333333333333333U) + (word >> 2 & 0x3333333333333333U);
    word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fU;
    return static_cast<int>(word * 0x0101010101010101U >> 56);
}

/// The number of ones in all words.
[[nodiscard]] constexpr std::int64_t count_ones(std::span<const std::uint64_t> words) {
    std::int64_t count = 0;
    for (const std::uint64_t word : words)
        count += count_ones(word);
    return count;
}

}  // namespace ink::core
