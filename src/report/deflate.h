#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink::report {

/// `bytes` in zlib's format, as a browser's DecompressionStream("deflate") reads them.
[[nodiscard]] std::vector<std::uint8_t> deflated(std::span<const std::byte> bytes);

}  // namespace ink::report
