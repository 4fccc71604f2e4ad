#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ink::report {

/// The template with each {{name}} replaced; one pass, so that no value is looked into. Throws
/// std::out_of_range for a name without a value.
[[nodiscard]] std::string filled(std::string_view page,
                                 const std::map<std::string, std::string>& values);

/// As text that may stand in a script element: "<" is written as an escape, and what is no UTF-8
/// replaced.
[[nodiscard]] std::string page_json(const nlohmann::ordered_json& json);

/// `bytes` in zlib's format, as a browser's DecompressionStream("deflate") reads them.
[[nodiscard]] std::vector<std::uint8_t> deflated(std::span<const std::byte> bytes);

}  // namespace ink::report
