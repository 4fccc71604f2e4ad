#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace ink::core {

/// The `name` of each.
template <class All>
[[nodiscard]] std::vector<std::string> names_of(const All& all) {
    std::vector<std::string> names;
    for (const auto& each : all)
        names.emplace_back(each.name);
    return names;
}

/// The one that is called `name`; null if none is.
template <class All>
[[nodiscard]] auto find_named(All& all, std::string_view name) {
    const auto is_it = [&](const auto& each) { return each.name == name; };
    const auto found = std::find_if(std::begin(all), std::end(all), is_it);
    return found == std::end(all) ? nullptr : &*found;
}

}  // namespace ink::core
