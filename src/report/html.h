#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace ink::report {

/// `text` as it may stand between tags or inside a quoted attribute of HTML or SVG: the five marks
/// & < > " ' become entities, control characters other than tab and line break vanish.
///
/// Every name that comes from outside (scenes are called after users' files) goes through here.
[[nodiscard]] std::string escape(std::string_view text);

/// RFC 4648 base64 with padding.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

/// A PNG file as a data: URI.
[[nodiscard]] std::string png_uri(std::span<const std::uint8_t> png);

}  // namespace ink::report
