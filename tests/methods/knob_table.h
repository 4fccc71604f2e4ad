#pragma once

#include <string>

#include "method/method.h"

namespace ink::methods {

/// The knobs of a method as a Markdown table, one row each: what stands in its page between the
/// lines
/// `<!-- knobs -->` and `<!-- /knobs -->`. Ends with a newline.
[[nodiscard]] std::string knob_table(const method::MethodInfo& method);

}  // namespace ink::methods
