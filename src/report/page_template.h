#pragma once

#include <map>
#include <string>
#include <string_view>

namespace ink::report {

/// The template with each {{name}} replaced; one pass, so that no value is looked into. Throws
/// std::out_of_range for a name without a value.
[[nodiscard]] std::string filled(std::string_view page,
                                 const std::map<std::string, std::string>& values);

}  // namespace ink::report
