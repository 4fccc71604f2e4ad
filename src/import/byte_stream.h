#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ink::import {

/// Takes the next bytes of a stream.
using ByteSink = std::function<void(const void* data, std::size_t size)>;

/// Writes values, arrays and texts as they lie in memory.
class ByteWriter {
  public:
    explicit ByteWriter(const ByteSink& sink) : sink_(sink) {}

    template <class T>
    void value(const T& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        sink_(&v, sizeof v);
    }
    template <class T>
    void items(std::span<const T> v) {
        value<std::uint64_t>(v.size());
        if (!v.empty()) sink_(v.data(), v.size_bytes());
    }
    void text(const std::string& s) { items(std::span<const char>(s)); }

  private:
    const ByteSink& sink_;
};

/// Reads values until the bytes run out; from then on `ok` is false and all values are zero.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : left_(bytes) {}

    template <class T>
    T value() {
        static_assert(std::is_trivially_copyable_v<T>);
        T v{};
        if (left_.size() < sizeof v) return fail(), v;
        std::memcpy(&v, left_.data(), sizeof v);
        left_ = left_.subspan(sizeof v);
        return v;
    }
    /// How many things follow, each at least `least_bytes` long: a count that cannot be is a
    /// failure.
    std::size_t count(std::size_t least_bytes) {
        const auto n = value<std::uint64_t>();
        if (n > left_.size() / least_bytes) return fail(), 0;
        return static_cast<std::size_t>(n);
    }
    template <class T>
    void items(std::vector<T>& out) {
        out.resize(count(sizeof(T)));
        if (out.empty()) return;
        std::memcpy(out.data(), left_.data(), out.size() * sizeof(T));
        left_ = left_.subspan(out.size() * sizeof(T));
    }
    std::string text() {
        std::vector<char> characters;
        items(characters);
        return {characters.begin(), characters.end()};
    }
    [[nodiscard]] bool ok() const { return ok_; }
    [[nodiscard]] bool at_end() const { return ok_ && left_.empty(); }

  private:
    void fail() {
        ok_ = false;
        left_ = {};
    }
    std::span<const std::byte> left_;
    bool ok_ = true;
};

/// A list of things, each at least `least_bytes` long, by `read`.
template <class T, class Read>
void read_all(ByteReader& reader, std::size_t least_bytes, std::vector<T>& out, Read read) {
    const std::size_t n = reader.count(least_bytes);
    for (std::size_t i = 0; i < n && reader.ok(); ++i)
        out.push_back(read(reader));
}

}  // namespace ink::import
