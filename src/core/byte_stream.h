#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ink::core {

/// Takes the next bytes of a stream.
using ByteSink = std::function<void(const void* data, std::size_t size)>;

// ByteWriter and ByteReader have the same calls, so that one function template says for both of
// which parts a thing consists: pass(stream, thing), the thing constant where it is written.

/// Writes values, arrays and texts as they lie in memory. Borrows the sink.
class ByteWriter {
  public:
    explicit ByteWriter(const ByteSink& sink) : sink_(sink) {}

    /// Each part: a value, a text, or a vector of values behind its count.
    template <class... Parts>
    void parts(const Parts&... parts) {
        (part(parts), ...);
    }
    /// A list behind its count, each thing by `pass`.
    template <class T, class Pass>
    void list(const std::vector<T>& things, std::size_t /*least_bytes*/, const Pass& pass) {
        part(static_cast<std::uint64_t>(things.size()));
        for (const T& thing : things)
            pass(*this, thing);
    }

  private:
    template <class T>
    void part(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        sink_(&value, sizeof value);
    }
    template <class T>
    void part(const std::vector<T>& values) {
        items(std::span<const T>(values));
    }
    void part(const std::string& text) { items(std::span<const char>(text)); }
    template <class T>
    void items(std::span<const T> items) {
        static_assert(std::is_trivially_copyable_v<T>);
        part(static_cast<std::uint64_t>(items.size()));
        if (!items.empty()) sink_(items.data(), items.size_bytes());
    }

    const ByteSink& sink_;
};

/// The bytes that `write` gives a ByteWriter.
template <class Write>
[[nodiscard]] std::string written_bytes(const Write& write) {
    std::string bytes;
    const ByteSink sink = [&bytes](const void* data, std::size_t size) {
        bytes.append(static_cast<const char*>(data), size);
    };
    ByteWriter writer(sink);
    write(writer);
    return bytes;
}

/// Reads what a ByteWriter wrote until the bytes run out; from then on `is_good` is false and all
/// values are zero. Allocates no more than a small multiple of the bytes, whatever counts they
/// claim.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : left_(bytes) {}

    template <class... Parts>
    void parts(Parts&... parts) {
        (part(parts), ...);
    }
    template <class T>
    [[nodiscard]] T value() {
        T value{};
        part(value);
        return value;
    }
    /// Things that take at least `least_bytes` each, so that a claimed count can be judged.
    template <class T, class Pass>
    void list(std::vector<T>& things, std::size_t least_bytes, const Pass& pass) {
        const std::size_t n = count(least_bytes);
        for (std::size_t i = 0; i < n && is_good_; ++i)
            pass(*this, things.emplace_back());
    }

    /// What was read makes no sense: nothing more is.
    void fail() {
        is_good_ = false;
        left_ = {};
    }
    [[nodiscard]] bool is_good() const { return is_good_; }
    [[nodiscard]] bool is_at_end() const { return is_good_ && left_.empty(); }
    [[nodiscard]] std::span<const std::byte> left() const { return left_; }

  private:
    template <class T>
    void part(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        take(&value, sizeof value);
    }
    void part(bool& value) {
        const auto byte = this->value<std::uint8_t>();
        if (byte > 1) fail();
        value = byte == 1;
    }
    template <class T>
    void part(std::vector<T>& values) {
        values.resize(count(sizeof(T)));
        take(values.data(), values.size() * sizeof(T));
    }
    void part(std::string& text) {
        text.resize(count(1));
        take(text.data(), text.size());
    }
    std::size_t count(std::size_t least_bytes) {
        const auto n = value<std::uint64_t>();
        if (n <= left_.size() / least_bytes) return static_cast<std::size_t>(n);
        return fail(), 0;
    }
    void take(void* to, std::size_t size) {
        if (size > left_.size()) return fail();
        if (size > 0) std::memcpy(to, left_.data(), size);
        left_ = left_.subspan(size);
    }

    std::span<const std::byte> left_;
    bool is_good_ = true;
};

}  // namespace ink::core
