#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace ink::report {

/// RFC 4648 base64 with padding.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

/// A PNG file as a data: URI.
[[nodiscard]] std::string png_uri(std::span<const std::uint8_t> png);

}  // namespace ink::report
