#include "core/bits.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <vector>

namespace ink::core {
namespace {

TEST(CountOnes, IsThatOfTheStandardLibrary) {
    std::mt19937_64 random(1);
    std::vector<std::uint64_t> words = {0, 1, ~std::uint64_t{0}, std::uint64_t{1} << 63};
    for (int i = 0; i < 1000; ++i)
        words.push_back(random() & random());
    std::int64_t all = 0;
    for (const std::uint64_t word : words) {
        EXPECT_EQ(count_ones(word), std::popcount(word)) << word;
        all += std::popcount(word);
    }
    EXPECT_EQ(count_ones(words), all);
}

}  // namespace
}  // namespace ink::core
