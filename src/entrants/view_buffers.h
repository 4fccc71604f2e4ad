#pragma once

#include <array>
#include <cstdint>
#include <filesystem>

#include "core/image.h"
#include "scene/scene.h"

namespace ink::entrants {

/// What each pixel centre of a view sees, as engines have it in their buffers.
struct ViewBuffers {
    core::Image<std::uint32_t> triangle;  ///< global index, kNoId for the sky
    core::Image<std::uint32_t> object;    ///< instance
    core::Image<std::uint32_t> patch;     ///< smooth patch within its object
    core::Image<std::uint32_t> material;
    core::Image<float> w;                      ///< distance along the view direction, infinity
    std::array<core::Image<float>, 3> normal;  ///< view space, unit, over patches; 0 for the sky
};

/// Draws the buffers of a view: ids by the rasterizer of the methods, distance and normal from the
/// triangle that is seen. `crease_rad` parts smooth patches.
[[nodiscard]] ViewBuffers view_buffers(const scene::Scene& scene,
                                       const scene::View& view,
                                       double crease_rad);

/// Writes them as multi-layer OpenEXR: `Z`, `N.X N.Y N.Z`, `id.triangle id.object id.patch
/// id.material`. Throws core::Error if the file cannot be written.
void write_buffers_exr(const ViewBuffers& buffers, const std::filesystem::path& path);

/// Writes the object ids as an 8-bit RGB PNG: red + 256 green + 65536 blue is the object id + 1, 0
/// for the sky. Throws core::Error if the file cannot be written.
void write_object_ids(const ViewBuffers& buffers, const std::filesystem::path& path);

}  // namespace ink::entrants
