#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace ink::import {

/// What a model file's own header says must follow; readers that stop early say nothing.
struct FileClaims {
    std::optional<std::uint64_t> bytes{};     ///< the file has at least this many
    std::optional<std::uint64_t> vertices{};  ///< it holds exactly this many
    std::optional<std::uint64_t> faces{};     ///< likewise, before triangulation
    std::optional<std::uint64_t> lines{};     ///< a text of at least this many
    bool ends_early = false;                  ///< a text that lacks its closing word
};

/// The claims in `head`, the first bytes of a file of `size` bytes whose last bytes are `tail`.
///
/// Knows 3DS, binary glTF, MD2, MD3, STL, PLY and OFF; of any other file it claims nothing. STL has
/// no magic, so `extension` (lower case, with its dot) decides there. 64 KiB of head and 4 KiB of
/// tail are plenty.
[[nodiscard]] FileClaims read_claims(std::span<const std::byte> head,
                                     std::span<const std::byte> tail,
                                     std::uint64_t size,
                                     const std::string& extension);

}  // namespace ink::import
