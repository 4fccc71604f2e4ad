#pragma once

#include <cstdint>
#include <vector>

#include "scene/prepared_scene.h"
#include "scene/topology.h"

namespace ink::buffers {

/// A triangle that became no face since one has the same corners: equally deep, either may be the
/// one that is seen.
struct RepeatedFace {
    std::uint32_t triangle = 0;  ///< global
    std::uint32_t face = 0;      ///< of the topology
};

/// Those of a scene, by triangle; `topology` is its own.
[[nodiscard]] std::vector<RepeatedFace> repeated_faces(const scene::PreparedScene& scene,
                                                       const scene::Topology& topology);

}  // namespace ink::buffers
