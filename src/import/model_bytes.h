#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/error.h"

namespace ink::import {

/// What a file asks for is known, or said to be needed, and not read here: the file is not damaged.
class Refusal : public core::Error {
  public:
    using core::Error::Error;
};

/// The bytes of a regular file, `most` at most; nothing if it cannot be read.
[[nodiscard]] std::optional<std::vector<std::byte>> read_file(
    const std::filesystem::path& path,
    std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
/// All bytes of a file; none of one that cannot be read.
[[nodiscard]] std::vector<std::byte> bytes_of(const std::filesystem::path& path);
/// Bytes as text. Borrows them.
[[nodiscard]] std::string_view text_of(std::span<const std::byte> bytes);
/// The number at `offset`, which is there.
template <class T>
[[nodiscard]] T number_at(std::span<const std::byte> bytes, std::size_t offset) {
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}
/// Its first 4096 bytes, or as many as it has.
[[nodiscard]] std::string head_of(const std::filesystem::path& path);

/// A text without the mark (U+FEFF) that some writers put before UTF-8.
[[nodiscard]] std::string_view without_mark(std::string_view text);

/// Whether a file's first bytes are UTF-16: by its mark, or because they are ASCII with a zero byte
/// to each.
[[nodiscard]] bool is_utf16(std::string_view head);

/// ASCII letters made small.
[[nodiscard]] std::string lower_case(std::string text);

/// A foreign binary file, little endian, of which nothing is read that is not there.
///
/// Whatever is wrong becomes an Error whose message says at which byte, what, and what would do.
class ModelBytes {
  public:
    /// `name` stands in front of every complaint; "" for the file that the user named.
    ModelBytes(std::string name, std::vector<std::byte> bytes)
        : name_(std::move(name)), bytes_(std::move(bytes)) {}

    [[nodiscard]] std::uint64_t size() const { return bytes_.size(); }

    [[noreturn]] void fail(std::uint64_t offset,
                           const std::string& what,
                           const std::string& accepted) const {
        const std::string place = name_.empty() ? "" : name_ + ", ";
        throw core::Error(name_, place + "byte " + std::to_string(offset) + ": " + what, accepted);
    }

    /// Fails unless `count` things of `each` bytes lie in the file from `offset` on.
    void need(std::uint64_t offset,
              std::uint64_t count,
              std::uint64_t each,
              const std::string& what) const {
        if (offset <= size() && count <= (size() - offset) / each) return;
        fail(offset,
             std::to_string(count) + ' ' + what + " do not fit into the file",
             std::to_string(each) + " bytes each, " + std::to_string(size()) + " bytes in all");
    }

    template <class T>
    [[nodiscard]] T at(std::uint64_t offset) const {
        need(offset, 1, sizeof(T), "number");
        return number_at<T>(bytes_, offset);
    }

    /// A whole number that counts `what`, least .. 2^31 - 1.
    [[nodiscard]] std::uint64_t count_at(std::uint64_t offset,
                                         const std::string& what,
                                         std::int32_t least) const {
        const auto count = at<std::int32_t>(offset);
        if (count < least) {
            fail(offset, std::to_string(count) + ' ' + what, std::to_string(least) + " or more");
        }
        return static_cast<std::uint64_t>(count);
    }

    /// An index of one of `count` things.
    template <class T>
    [[nodiscard]] std::uint32_t index_at(std::uint64_t offset,
                                         const std::string& what,
                                         std::uint64_t count) const {
        const auto index = at<T>(offset);
        if (std::cmp_less(index, 0) || std::cmp_greater_equal(index, count)) {
            fail(offset,
                 what + ' ' + std::to_string(index),
                 "0.." + std::to_string(count == 0 ? 0 : count - 1));
        }
        return static_cast<std::uint32_t>(index);
    }

    /// The zero-ended text in a field of `most` bytes.
    [[nodiscard]] std::string text_at(std::uint64_t offset, std::size_t most) const {
        need(offset, most, 1, "characters");
        const char* first = reinterpret_cast<const char*>(bytes_.data()) + offset;
        return {first, strnlen(first, most)};
    }

  private:
    std::string name_;
    std::vector<std::byte> bytes_;
};

}  // namespace ink::import
