#pragma once

#include <glm/vec3.hpp>

#include "core/image.h"
#include "raster/pass.h"
#include "scene/scene.h"
#include "scene/surface.h"

namespace ink::shade {

/// How a shaded picture is drawn.
struct GouraudOptions {
    glm::vec3 surface{0.9F, 0.88F, 0.85F};  ///< the part of the light that every surface sends back
    glm::vec3 ambient{0.22F};               ///< light that arrives everywhere
    glm::vec3 paper{1};                     ///< the picture where there is no surface
    scene::NormalSource normals = scene::NormalSource::patch;
    double crease_rad = 0.6981317007977318;  ///< 40 degrees: patches end at sharper edges
    raster::Interpolation interpolation = raster::Interpolation::perspective;
    int threads = 1;
};

/// The scene under its own lamps (or `studio_lamps` if it has none), lit at vertices and
/// interpolated.
///
/// Gouraud 1971, "Continuous shading of curved surfaces", with Lambert's law at vertices; a lamp
/// that reaches no vertex of a triangle is lost on it, as it was in 1998. A triangle seen from its
/// back is lit from its back. No shadows. Brightness 0 .. 1 and beyond, not limited; an empty
/// picture stays empty.
[[nodiscard]] core::Image<glm::vec3> draw_gouraud(const scene::Scene& scene,
                                                  const scene::View& view,
                                                  const GouraudOptions& options);

}  // namespace ink::shade
