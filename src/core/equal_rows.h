#pragma once

#include <algorithm>
#include <span>

namespace ink::core {

/// Of a list that is sorted by `member` the rows in which it is `key`. For
/// std::ranges::equal_range, which Clang 14 cannot compile with this standard library.
template <class Row, class Key>
[[nodiscard]] std::span<const Row> equal_rows(std::span<const Row> sorted,
                                              const Key& key,
                                              Key Row::*member) {
    const auto begin = std::ranges::lower_bound(sorted, key, {}, member);
    return {begin, std::ranges::upper_bound(begin, sorted.end(), key, {}, member)};
}

}  // namespace ink::core
