#pragma once

#include <string>
#include <vector>

#include "raster/skips.h"

namespace ink::harness {

/// What is allowed where one view is drawn again and again to be timed: all skips but
/// `temporal_reuse`. With it, every drawing but the first would cost next to nothing, which is no
/// method's time for that view.
[[nodiscard]] raster::SkipSet skips_of_repeated_drawings();

/// `allowed` without the skips of these names; "all" is every one. Throws core::Error
/// (where = "--no-skip") that lists the names if one is unknown.
[[nodiscard]] raster::SkipSet without_skips(raster::SkipSet allowed,
                                            const std::vector<std::string>& names);

/// The skips that `allowed` forbids: names joined by ';' in the order of the table, "" if none.
[[nodiscard]] std::string forbidden_skips(const raster::SkipSet& allowed);

}  // namespace ink::harness
