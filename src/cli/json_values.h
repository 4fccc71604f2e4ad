#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace ink::cli {

/// The value, or null where there is none: neither 0 nor NaN, which would slip into a mean.
template <class T>
[[nodiscard]] nlohmann::json or_null(const std::optional<T>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

}  // namespace ink::cli
