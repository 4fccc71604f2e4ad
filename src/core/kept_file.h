#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ink::core {

// Files of what was worked out before. They are read back only if they are whole and stand for the
// same question; whatever is wrong with them costs the work again, and is no error.

/// Says what kind of thing is kept.
using KeptKind = std::array<char, 8>;

/// `payload` behind a head: its kind, the key of the question, hash and length. Machine byte order.
[[nodiscard]] std::string sealed(const KeptKind& kind,
                                 const std::string& key,
                                 std::string_view payload);

/// The payload that was sealed with this kind and key; nothing if the bytes are cut off, changed,
/// of another key or of another kind. Lies within `bytes`.
[[nodiscard]] std::optional<std::span<const std::byte>> unsealed(std::string_view bytes,
                                                                 const KeptKind& kind,
                                                                 const std::string& key);

/// Writes a file whole, in a folder that is made if need be. What cannot be kept is worked out
/// again the next time: that costs time, nothing else, so no error is told.
void keep_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace ink::core
