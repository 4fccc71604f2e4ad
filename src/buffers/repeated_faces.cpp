#include "buffers/repeated_faces.h"

#include <algorithm>
#include <array>
#include <map>

#include "scene/surface.h"

namespace ink::buffers {
namespace {

using Places = std::array<std::array<double, 3>, 3>;

/// The corners in an order that does not depend on that of the triangle.
Places places_of(const std::vector<glm::dvec3>& p_world, const std::array<std::uint32_t, 3>& at) {
    Places places;
    for (std::size_t i = 0; i < 3; ++i)
        places[i] = {p_world[at[i]].x, p_world[at[i]].y, p_world[at[i]].z};
    std::sort(places.begin(), places.end());
    return places;
}

}  // namespace

std::vector<RepeatedFace> repeated_faces(const scene::PreparedScene& scene,
                                         const scene::Topology& topology) {
    std::vector<RepeatedFace> repeated;
    if (topology.counts.duplicate == 0) return repeated;
    std::map<Places, std::uint32_t> face_at;
    std::vector<bool> is_face(scene::triangle_count(scene));
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        is_face[topology.faces[f].triangle] = true;
        face_at.emplace(places_of(topology.p_world, topology.faces[f].vertices), f);
    }
    const auto flat = scene.surface();
    const scene::Surface& surface = *flat;
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        if (is_face[t]) continue;
        const auto found = face_at.find(places_of(surface.p_world, surface.triangles[t]));
        if (found != face_at.end()) repeated.push_back({t, found->second});
    }
    return repeated;
}

}  // namespace ink::buffers
