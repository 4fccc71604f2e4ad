#pragma once

#include <optional>
#include <vector>

#include "draw/explain.h"
#include "scene/ledger.h"

namespace ink::draw {

/// What skips ask of a scene.
struct SceneFacts {
    scene::Ledger ledger;
    std::vector<scene::ViewLedger> views;
    std::size_t solids = 0;  ///< as the rasterizer cuts them: within one object each
    std::size_t sealed_solids = 0;
};

/// Which channels of `code` are of no use on a scene with this ledger; empty without a code.
[[nodiscard]] std::vector<Omission> channel_omissions(const std::optional<method::LinearCode>& code,
                                                      const scene::Ledger& ledger);

/// Every skip of raster::skip_infos(), in their order: whether the method may use it here.
[[nodiscard]] std::vector<Omission> skip_omissions(const std::optional<method::LinearCode>& code,
                                                   const SceneFacts& facts);

}  // namespace ink::draw
