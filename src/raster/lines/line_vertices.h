#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "raster/pass/screen_vertex.h"
#include "raster/pass/view_transform.h"

namespace ink::raster {

/// Where vertices go that are put on the screen, one array each.
struct ScreenVertices {
    glm::dvec3* p_clip = nullptr;
    ScreenVertex* screen = nullptr;  ///< written where the outcode is kInside
    std::uint8_t* outcodes = nullptr;
};

/// What to_clip(), outcode() and to_screen() make of `count` vertices, bit by bit, some at a time.
void project_vertices(const ViewTransform& transform,
                      double near,
                      const glm::dvec3* p_world,
                      std::size_t count,
                      const ScreenVertices& to);

}  // namespace ink::raster
