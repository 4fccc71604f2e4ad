#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace ink::cli {

/// The value, or null where there is none: neither 0 nor NaN, which would slip into a mean.
template <class T>
[[nodiscard]] nlohmann::json or_null(const std::optional<T>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

/// An array of what `json_of` makes of each.
template <class Json = nlohmann::json, class All, class JsonOf>
[[nodiscard]] Json list_of(const All& all, JsonOf json_of) {
    Json list = Json::array();
    for (const auto& each : all)
        list.push_back(json_of(each));
    return list;
}

}  // namespace ink::cli
