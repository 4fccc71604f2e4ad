#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "core/error.h"

namespace ink::import {
struct ImportReply;
}

namespace ink::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A law that does not hold. Nothing catches it: it ends a run of libFuzzer, and fails the test of
/// the corpus.
class BrokenLaw : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

inline void expect(bool holds, const char* law) {
    if (!holds) throw BrokenLaw(law);
}

/// Makes numbers of bytes, in their order. Where the bytes have run out, numbers are made of zeros.
class Feed {
  public:
    explicit Feed(Bytes bytes) : left_(bytes) {}

    [[nodiscard]] bool is_empty() const { return left_.empty(); }
    [[nodiscard]] Bytes rest() const { return left_; }

    /// The bytes of a T as they stand.
    template <class T>
    [[nodiscard]] T raw() {
        T value{};
        const std::size_t size = std::min(sizeof value, left_.size());
        if (size > 0) std::memcpy(&value, left_.data(), size);
        left_ = left_.subspan(size);
        return value;
    }
    /// A whole number in least..most, of one byte if there are at most 256 of them, else of four.
    [[nodiscard]] int whole(int least, int most) {
        const std::uint32_t count = static_cast<std::uint32_t>(most - least) + 1;
        const std::uint32_t bits = count <= 256 ? raw<std::uint8_t>() : raw<std::uint32_t>();
        return least + static_cast<int>(count == 0 ? bits : bits % count);
    }
    [[nodiscard]] bool flag() { return whole(0, 1) == 1; }
    /// A number in least..most, on a grid of 2^32 steps.
    [[nodiscard]] double real(double least, double most) {
        return least + (most - least) * (raw<std::uint32_t>() / 4294967295.0);
    }

  private:
    Bytes left_;
};

/// Throws BrokenLaw unless the message is what core::Error promises: one line, of one place.
inline void expect_clear(const core::Error& error) {
    const std::string line = error.what();
    expect(!error.what_happened().empty(), "an Error says what happened");
    for (const char c : line)
        expect(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "an Error is one line");
}

/// What `read` gives; nothing for an Error, which must be clear.
template <class Read>
[[nodiscard]] auto unless_refused(const Read& read) -> std::optional<decltype(read())> {
    try {
        return read();
    } catch (const core::Error& error) {
        expect_clear(error);
        return std::nullopt;
    }
}

/// Uses what was taken: an Error breaks the law that it can be used.
template <class Use>
void expect_usable(const std::string& law, const Use& use) {
    try {
        use();
    } catch (const core::Error& error) {
        throw BrokenLaw(law + ": " + error.what());
    }
}

/// A reply of a reader must go through a stream unchanged, and become a sound scene, in every pose,
/// or a clear Error. Throws BrokenLaw if not.
void expect_scene_or_error(const import::ImportReply& reply);

/// All targets: check_TARGET takes any bytes, and throws BrokenLaw if a law does not hold of them.
#define INK_FUZZ_TARGETS(TARGET) \
    TARGET(camera_json)          \
    TARGET(entrant_image)        \
    TARGET(entrant_times)        \
    TARGET(experiment)           \
    TARGET(fbx)                  \
    TARGET(gltf)                 \
    TARGET(kept_truth)           \
    TARGET(matching)             \
    TARGET(mesh_pass)            \
    TARGET(obj)                  \
    TARGET(off)                  \
    TARGET(ply)                  \
    TARGET(predicates)           \
    TARGET(preset)               \
    TARGET(quake_models)         \
    TARGET(rasterizer)           \
    TARGET(scene_stream)         \
    TARGET(score)                \
    TARGET(stl)

#define INK_FUZZ_DECLARED(name) void check_##name(Bytes bytes);
INK_FUZZ_TARGETS(INK_FUZZ_DECLARED)
#undef INK_FUZZ_DECLARED

}  // namespace ink::fuzz
