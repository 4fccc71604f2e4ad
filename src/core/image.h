#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

namespace ink::core {

/// A borrowed rectangle of pixels: (0,0) is top left, rows are `stride` elements apart.
///
/// Does not own its pixels; valid as long as the image it was taken from. `T` may be const.
template <class T>
struct ImageView {
    T* data = nullptr;
    int width_px = 0;
    int height_px = 0;
    std::ptrdiff_t stride = 0;  ///< elements (not bytes) from one row to the next

    [[nodiscard]] T* row(int y) const { return data + y * stride; }
    [[nodiscard]] T& at(int x, int y) const {
        assert(contains(x, y));
        return row(y)[x];
    }
    [[nodiscard]] bool contains(int x, int y) const {
        return x >= 0 && y >= 0 && x < width_px && y < height_px;
    }
    [[nodiscard]] bool is_empty() const { return width_px == 0 || height_px == 0; }
    operator ImageView<const T>() const requires(!std::is_const_v<T>) {
        return {data, width_px, height_px, stride};
    }
};

/// Memory that begins where a cache line does: vectors stored across lines cost twice.
template <class T>
struct LineAllocator {
    using value_type = T;
    static constexpr std::align_val_t kLine{64};

    LineAllocator() = default;
    template <class U>
    LineAllocator(const LineAllocator<U>&) {}
    [[nodiscard]] T* allocate(std::size_t count) {
        return static_cast<T*>(::operator new(count * sizeof(T), kLine));
    }
    void deallocate(T* pixels, std::size_t) { ::operator delete(pixels, kLine); }
    friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

/// An owned, dense image: `width_px * height_px` elements, row by row, (0,0) top left.
///
/// Pixel centres lie at +0.5. A default-constructed image is empty (0 x 0). Row 0 begins a cache
/// line.
template <class T>
class Image {
  public:
    Image() = default;
    Image(int width_px, int height_px, const T& fill = T{})
        : width_px_(width_px),
          height_px_(height_px),
          pixels_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), fill) {
        assert(width_px >= 0 && height_px >= 0);
    }

    [[nodiscard]] int width_px() const { return width_px_; }
    [[nodiscard]] int height_px() const { return height_px_; }
    [[nodiscard]] std::size_t size() const { return pixels_.size(); }
    [[nodiscard]] bool is_empty() const { return pixels_.empty(); }

    [[nodiscard]] T* data() { return pixels_.data(); }
    [[nodiscard]] const T* data() const { return pixels_.data(); }
    [[nodiscard]] T* row(int y) { return data() + static_cast<std::ptrdiff_t>(y) * width_px_; }
    [[nodiscard]] const T* row(int y) const {
        return data() + static_cast<std::ptrdiff_t>(y) * width_px_;
    }
    [[nodiscard]] T& at(int x, int y) {
        assert(contains(x, y));
        return row(y)[x];
    }
    [[nodiscard]] const T& at(int x, int y) const {
        assert(contains(x, y));
        return row(y)[x];
    }
    [[nodiscard]] bool contains(int x, int y) const {
        return x >= 0 && y >= 0 && x < width_px_ && y < height_px_;
    }

    [[nodiscard]] ImageView<T> view() { return {data(), width_px_, height_px_, width_px_}; }
    [[nodiscard]] ImageView<const T> view() const {
        return {data(), width_px_, height_px_, width_px_};
    }
    void fill(const T& value) { pixels_.assign(pixels_.size(), value); }

    friend bool operator==(const Image&, const Image&) = default;

  private:
    int width_px_ = 0;
    int height_px_ = 0;
    std::vector<T, LineAllocator<T>> pixels_;
};

/// The image of what `map` makes of each pixel.
template <class To, class From, class Map>
[[nodiscard]] Image<To> mapped(const Image<From>& image, Map map) {
    Image<To> result(image.width_px(), image.height_px());
    std::transform(image.data(), image.data() + image.size(), result.data(), map);
    return result;
}

}  // namespace ink::core
