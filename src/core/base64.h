#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace ink::core {

/// Bytes in the 64 letters of RFC 4648, filled up with = to a multiple of four; "" for none.
[[nodiscard]] std::string base64(std::span<const std::byte> bytes);

}  // namespace ink::core
