#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ink::import {

/// The number of the animation that `asked` means among `names`: one called so, else the one of
/// that number; the first if nothing is asked. Throws Refusal that lists them.
[[nodiscard]] std::size_t choose_animation(const std::vector<std::string>& names,
                                           const std::string& asked);

}  // namespace ink::import
