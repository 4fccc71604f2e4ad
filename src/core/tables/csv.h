#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace ink::core {

/// A CSV field: quoted as RFC 4180 has it if it holds a comma, a quote or a line break.
[[nodiscard]] std::string csv_field(const std::string& text);

/// A number in the shortest form that reads back to the same value, whatever the locale.
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string number_text(std::int64_t value);
[[nodiscard]] std::string number_text(std::uint64_t value);

/// A value as a field: text quoted where it must be, numbers as number_text has them; nothing is an
/// empty field.
template <class T>
[[nodiscard]] std::string csv_text(const T& value) {
    if constexpr (std::is_convertible_v<T, std::string_view>) {
        return csv_field(std::string(value));
    } else if constexpr (std::is_same_v<T, bool>) {
        return value ? "true" : "false";
    } else if constexpr (std::is_same_v<T, double>) {
        return number_text(value);
    } else if constexpr (std::unsigned_integral<T>) {
        return number_text(std::uint64_t{value});
    } else {
        return number_text(std::int64_t{value});
    }
}
template <class T>
[[nodiscard]] std::string csv_text(const std::optional<T>& value) {
    return value ? csv_text(*value) : "";
}

}  // namespace ink::core
