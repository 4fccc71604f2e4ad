#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace ink::core {

/// The numbers 0..count-1 in sets that are joined two by two: Tarjan's union-find with path
/// halving.
///
/// A set is named by its lowest number, so that names do not depend on the order of joins.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    /// The lowest number of the set that `i` (below the count) is in.
    [[nodiscard]] std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t i, std::uint32_t j) {
        i = root(i);
        j = root(j);
        parent_[std::max(i, j)] = std::min(i, j);
    }

    /// Per member the number of its set, and how many sets there are: they count from 0, in the
    /// order of their lowest members.
    [[nodiscard]] std::pair<std::vector<std::uint32_t>, std::uint32_t> numbers() {
        std::vector<std::uint32_t> numbers(parent_.size());
        std::uint32_t count = 0;
        for (std::uint32_t i = 0; i < parent_.size(); ++i) {
            const std::uint32_t lowest = root(i);  // numbered before the others
            numbers[i] = lowest == i ? count++ : numbers[lowest];
        }
        return {std::move(numbers), count};
    }

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace ink::core
