#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/image.h"

namespace ink::core {

/// A running 64-bit hash of bytes: names results and cache files; not for secrets.
///
/// The same bytes in the same order give the same value on every machine and in every version (the
/// golden hashes of the tests rest on it). Reads eight bytes a step; each step is
/// multiply-xorshift, the finaliser of MurmurHash3 (Appleby, public domain description).
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

    /// How many bytes_beside hashes at a time.
    static constexpr std::size_t kBeside = 4;

    /// Does hashers[i].bytes(data[i], size) for every i, kBeside at a time: a hash waits for each
    /// of its steps, so four take little longer than one. As many hashers as data.
    static void bytes_beside(std::span<Hasher> hashers,
                             std::span<const void* const> data,
                             std::size_t size);

    [[nodiscard]] std::uint64_t result() const { return state_; }
    /// Sixteen lower-case hexadecimal digits.
    [[nodiscard]] std::string hex() const;

  private:
    void step(std::uint64_t word);
    std::uint64_t state_ = 0x9e3779b97f4a7c15ULL;
};

/// The hash of an image: its size and its pixels.
template <class T>
[[nodiscard]] std::string image_hash(const Image<T>& image) {
    Hasher hasher;
    hasher.value(image.width_px()).value(image.height_px());
    hasher.bytes(image.data(), image.size() * sizeof(T));
    return hasher.hex();
}

/// The hash of each image, as image_hash has it; of images of one size in a third of the time.
template <class T>
[[nodiscard]] std::vector<std::string> image_hashes(std::span<const Image<T>* const> images) {
    std::vector<std::string> hashes;
    for (std::size_t begin = 0; begin < images.size();) {
        const Image<T>& first = *images[begin];
        std::vector<Hasher> hashers;
        std::vector<const void*> data;
        for (std::size_t i = begin; i < images.size(); ++i) {
            const Image<T>& image = *images[i];
            if (image.width_px() != first.width_px() || image.height_px() != first.height_px())
                break;
            hashers.push_back(Hasher().value(image.width_px()).value(image.height_px()));
            data.push_back(image.data());
        }
        Hasher::bytes_beside(hashers, data, first.size() * sizeof(T));
        for (const Hasher& hasher : hashers)
            hashes.push_back(hasher.hex());
        begin += hashers.size();
    }
    return hashes;
}

}  // namespace ink::core
