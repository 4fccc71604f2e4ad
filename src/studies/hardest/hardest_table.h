#pragma once

#include <string>
#include <vector>

#include "core/tables/table_of.h"
#include "studies/hardest/hardest_view.h"

namespace ink::studies {

/// hardest.csv: a line per view that was looked at, with its ink if soft F is searched.
[[nodiscard]] core::TableOf<HardestLook> hardest_table(bool has_ink);

/// For a terminal: a line per scene and method with F over the scene's own views, pooled, and the
/// least that was found; below it where the worst view of all is. "" for no looks.
[[nodiscard]] std::string hardest_text(const std::vector<HardestLook>& looks);

}  // namespace ink::studies
