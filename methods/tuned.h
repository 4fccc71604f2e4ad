#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "method/method.h"

namespace ink::methods {

/// A shipped preset as the build took it in: the text of `methods/<name>/<name>.toml`.
struct ShippedPreset {
    std::string_view name;
    std::string_view text;
};

/// The presets that come with the program, in the order in which tables show them.
[[nodiscard]] std::span<const ShippedPreset> shipped_presets();

/// Their rows for the registry, made from the methods in `bases`. A shipped file that cannot be
/// read is an Error at the program's first look at its registry, which the tests take.
[[nodiscard]] std::vector<method::MethodInfo> tuned_methods(
    const std::vector<method::MethodInfo>& bases);

}  // namespace ink::methods
