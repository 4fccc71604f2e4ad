#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace ink::core {

/// All of `text` as a number, whatever the locale; nothing for any other text. Whole numbers may
/// have a `base`.
template <class T, class... Base>
[[nodiscard]] std::optional<T> parse_number(std::string_view text, Base... base) {
    T value{};
    const char* last = text.data() + text.size();
    const auto [end, status] = std::from_chars(text.data(), last, value, base...);
    return status == std::errc{} && end == last ? std::optional(value) : std::nullopt;
}

}  // namespace ink::core
