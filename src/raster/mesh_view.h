#pragma once

#include <cstdint>
#include <vector>

#include "raster/mesh_pass.h"
#include "raster/view_transform.h"

namespace ink::raster {

/// What a frame decides about each solid before any of its clusters is looked at.
struct SolidView {
    bool hides_backs = false;  ///< sealed, and seen from outside: a face turned away is never seen
};

/// Looks at every solid once.
[[nodiscard]] std::vector<SolidView> view_solids(const MeshInput& input);

/// The order in which clusters are drawn: by the distance of their centres in coarse steps, as they
/// come within one. What lies behind is then mostly found hidden, and neighbours stay together.
[[nodiscard]] std::vector<std::uint32_t> front_to_back(const MeshInput& input);

/// Whether a ball lies beyond the near plane or one side of the picture, with room for rounding.
[[nodiscard]] bool is_outside(const scene::Sphere& ball,
                              const ViewTransform& transform,
                              const scene::View& view);

}  // namespace ink::raster
