#pragma once

#include "method/method.h"

namespace ink::methods {

/// Dark where a surface turns away from the eye.
[[nodiscard]] method::MethodInfo my_method();

}  // namespace ink::methods
