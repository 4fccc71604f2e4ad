#pragma once

#include <string>
#include <vector>

#include "core/param.h"
#include "methods/registry.h"

namespace ink::lab {

/// A method as it takes part: which, and with which settings.
struct Entrant {
    const methods::MethodInfo* info = nullptr;
    core::ParamValues settings;  ///< what the user set; the rest is default
};

/// "a,b,c" as its parts, empty ones left out.
[[nodiscard]] std::vector<std::string> split_list(const std::string& text);

/// The entrants that a comma list of methods and some settings name; an empty list is every method.
///
/// A setting is `key=value` (for every method that knows the key) or `method.key=value`. Throws
/// core::Error for an unknown method, a method named twice, a key that nobody knows, a bad value.
[[nodiscard]] std::vector<Entrant> make_entrants(const std::string& methods,
                                                 const std::vector<std::string>& settings);

}  // namespace ink::lab
