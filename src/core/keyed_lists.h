#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace ink::core {

/// Entries in lists, one list a key, all in one piece; in each they stand as they came.
template <class Entry>
class KeyedLists {
  public:
    KeyedLists() = default;
    /// `each` calls its argument with (key, entry) for all of them, the same whenever asked. Keys
    /// count from 0.
    template <class Each>
    KeyedLists(std::size_t key_count, const Each& each) : first_(key_count + 2, 0) {
        // Counts stand two behind their keys, so that filling leaves firsts and ends in place.
        each([&](std::size_t key, const Entry&) { ++first_[key + 2]; });
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        entries_.resize(first_.back());
        each([&](std::size_t key, const Entry& entry) { entries_[first_[key + 1]++] = entry; });
        first_.pop_back();
    }

    [[nodiscard]] bool empty() const { return entries_.empty(); }
    [[nodiscard]] std::size_t key_count() const { return first_.size() - 1; }
    [[nodiscard]] std::span<const Entry> of(std::size_t key) const { return of(key, key); }
    [[nodiscard]] std::span<Entry> of(std::size_t key) {
        return {entries_.data() + first_[key], first_[key + 1] - first_[key]};
    }
    /// The lists of both keys and all between, one after the other.
    [[nodiscard]] std::span<const Entry> of(std::size_t first_key, std::size_t last_key) const {
        return {entries_.data() + first_[first_key], first_[last_key + 1] - first_[first_key]};
    }

  private:
    std::vector<std::uint32_t> first_;  ///< per key, and the end
    std::vector<Entry> entries_;
};

}  // namespace ink::core
