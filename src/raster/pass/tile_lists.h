#pragma once

#include <cstdint>

#include "raster/pass/aligned_array.h"

namespace ink::raster {

/// A list of numbers that keeps its memory when it is cleared.
class EntryList {
  public:
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] const std::uint32_t* data() const { return memory_.data(); }
    void clear() { size_ = 0; }
    void push(std::uint32_t entry) {
        if (size_ == memory_.size()) memory_.resize(2 * size_ + 64);
        memory_[size_++] = entry;
    }
    /// Room for `count` more; those written there count once `grow` says so.
    [[nodiscard]] std::uint32_t* room(std::size_t count) {
        if (size_ + count > memory_.size()) memory_.resize(2 * size_ + count);
        return memory_.data() + size_;
    }
    void grow(std::size_t count) { size_ += count; }

  private:
    AlignedArray<std::uint32_t> memory_;
    std::size_t size_ = 0;
};

}  // namespace ink::raster
