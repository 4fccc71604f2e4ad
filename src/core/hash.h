#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/image.h"

namespace ink::core {

/// A running 64-bit hash of what is added, one thing after the other: names results and cache
/// files; not for secrets.
///
/// Each thing is hashed by XXH3 with the hash of what came before as its seed, so the same things
/// in the same order give the same value on every machine and in every version (the golden hashes
/// of the tests rest on it). Of one run of bytes it is what `xxhsum -H3` says.
class Hasher {
  public:
    Hasher& bytes(const void* data, std::size_t size);

    /// Adds the object representation of a plain value without padding.
    template <class T>
    Hasher& value(const T& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        return bytes(&v, sizeof v);
    }
    /// Adds length and characters, so that ("ab","c") and ("a","bc") differ.
    Hasher& text(std::string_view s) { return value(s.size()).bytes(s.data(), s.size()); }

    /// Adds length and elements.
    template <class T>
    Hasher& items(std::span<const T> v) {
        static_assert(std::is_trivially_copyable_v<T>);
        return value(v.size()).bytes(v.data(), v.size_bytes());
    }

    [[nodiscard]] std::uint64_t result() const { return state_; }
    /// Sixteen lower-case hexadecimal digits.
    [[nodiscard]] std::string hex() const;

  private:
    std::uint64_t state_ = 0;
};

/// The hash of an image: its size and its pixels.
template <class T>
[[nodiscard]] std::string image_hash(const Image<T>& image) {
    Hasher hasher;
    hasher.value(image.width_px()).value(image.height_px());
    hasher.bytes(image.data(), image.size() * sizeof(T));
    return hasher.hex();
}

}  // namespace ink::core
