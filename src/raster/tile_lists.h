#pragma once

#include <cstdint>
#include <vector>

#include "raster/aligned_array.h"

namespace ink::raster {

/// A list of numbers with room for a whole vector to be written past its end.
class EntryList {
  public:
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] const std::uint32_t* data() const { return memory_.data(); }
    void clear() { size_ = 0; }
    void push(std::uint32_t entry) {
        if (size_ + kRoom > memory_.size()) grow();
        memory_[size_++] = entry;
    }

  private:
    static constexpr std::size_t kRoom = 16;
    void grow() { memory_.resize(size_ * 2 + 4 * kRoom); }

    AlignedArray<std::uint32_t> memory_;
    std::size_t size_ = 0;
};

}  // namespace ink::raster
