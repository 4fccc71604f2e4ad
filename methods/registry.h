#pragma once

#include <string>
#include <vector>

#include "method/method.h"

namespace ink::methods {

/// Every method, in the order in which tables show them. An explicit list: see registry.cpp.
[[nodiscard]] const std::vector<method::MethodInfo>& registry();

/// The method called `name`. Throws core::Error that lists the known names if there is none.
[[nodiscard]] const method::MethodInfo& find_method(const std::string& name);

}  // namespace ink::methods
