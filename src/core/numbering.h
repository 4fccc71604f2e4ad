#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/hash.h"

namespace ink::core {

/// Numbers keys in the order in which they first appear, from 0; open addressing, linear probing.
///
/// `K` is a plain value without padding that has ==. Keys are kept, so the table is also the list
/// of them.
template <class K>
class Numbering {
  public:
    /// Grows where there are more keys than `expected`.
    explicit Numbering(std::size_t expected) {
        slots_.assign(std::bit_ceil(std::max<std::size_t>(16, expected * 2)), kFree);
    }
    /// The number of `key`, and whether it is new.
    std::pair<std::uint32_t, bool> insert(const K& key) {
        if (keys_.size() * 2 >= slots_.size()) rebuild(slots_.size() * 2);
        const std::size_t slot = slot_of(key);
        if (slots_[slot] != kFree) return {slots_[slot], false};
        slots_[slot] = static_cast<std::uint32_t>(keys_.size());
        keys_.push_back(key);
        return {slots_[slot], true};
    }
    /// The number of `key`; nothing if it was never inserted.
    [[nodiscard]] std::optional<std::uint32_t> find(const K& key) const {
        const std::uint32_t number = slots_[slot_of(key)];
        return number == kFree ? std::nullopt : std::optional(number);
    }
    [[nodiscard]] std::vector<K>& keys() { return keys_; }

  private:
    static constexpr std::uint32_t kFree = 0xffffffffU;

    [[nodiscard]] std::size_t slot_of(const K& key) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = Hasher().value(key).result() & mask;
        while (slots_[slot] != kFree && !(keys_[slots_[slot]] == key))
            slot = (slot + 1) & mask;
        return slot;
    }
    void rebuild(std::size_t size) {
        slots_.assign(size, kFree);
        for (std::uint32_t i = 0; i < keys_.size(); ++i)
            slots_[slot_of(keys_[i])] = i;
    }

    std::vector<std::uint32_t> slots_;
    std::vector<K> keys_;
};

}  // namespace ink::core
