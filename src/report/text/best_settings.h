#pragma once

#include <string>
#include <vector>

#include "harness/row.h"

namespace ink::report {

/// For a terminal: a line per swept method with its best setting over the sweep's views, how far it
/// is from the method's own, and what each costs. "" without a sweep.
[[nodiscard]] std::string best_settings_table(const std::vector<harness::Row>& rows,
                                              const std::vector<harness::Row>& sweep);

}  // namespace ink::report
