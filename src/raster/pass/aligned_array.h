#pragma once

#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ink::raster {

/// Plain numbers at an address that fits every vector register; grows, never shrinks, and keeps
/// nothing when it grows beyond its capacity unless told to.
template <class T>
class AlignedArray {
  public:
    AlignedArray() = default;
    AlignedArray(const AlignedArray& other) {
        resize(other.size_);
        std::copy_n(other.data(), size_, data());
    }
    AlignedArray(AlignedArray&&) = default;
    AlignedArray& operator=(AlignedArray other) {
        std::swap(memory_, other.memory_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        return *this;
    }

    [[nodiscard]] T* data() { return memory_.get(); }
    [[nodiscard]] const T* data() const { return memory_.get(); }
    [[nodiscard]] std::size_t size() const { return size_; }
    T& operator[](std::size_t i) { return memory_[i]; }
    const T& operator[](std::size_t i) const { return memory_[i]; }

    /// `size` elements; those that were there keep their values, new ones have none.
    void resize(std::size_t size) {
        reserve(size);
        size_ = size;
    }
    /// Room for `size` elements at least.
    void reserve(std::size_t size) {
        if (size <= capacity_) return;
        const std::size_t capacity = std::max(size, capacity_ + capacity_ / 2);
        auto grown = hwy::AllocateAligned<T>(capacity);
        std::copy_n(memory_.get(), size_, grown.get());
        memory_ = std::move(grown);
        capacity_ = capacity;
    }

  private:
    hwy::AlignedFreeUniquePtr<T[]> memory_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

}  // namespace ink::raster
