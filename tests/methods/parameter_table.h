#pragma once

#include <string>

#include "method/method.h"

namespace ink::methods {

/// The parameters of a method as a Markdown table, one row each: what stands in its page between
/// the lines
/// `<!-- parameters -->` and `<!-- /parameters -->`. Ends with a newline.
[[nodiscard]] std::string parameter_table(const method::MethodInfo& method);

}  // namespace ink::methods
