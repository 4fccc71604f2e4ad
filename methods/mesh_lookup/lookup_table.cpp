#include "methods/mesh_lookup/lookup_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "methods/mesh_lookup/lookup_method.h"

namespace ink::methods {
namespace {

/// Per point of a mesh a corner that is there: 3 global index + 0..2.
std::vector<std::uint32_t> corners_at_points(const scene::Scene& scene, const LookupMesh& mesh) {
    std::vector<std::uint32_t> corners(mesh.p_world.size());
    std::uint32_t t = 0;
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& placed = scene.meshes[instance.mesh];
        for (const scene::Triangle& triangle : placed.triangles) {
            const std::uint32_t face = mesh.face_of_triangle[t];
            for (std::uint32_t i = 0; face != kNoNeighbour && i < 3; ++i) {
                const glm::dvec3 p = scene::to_world(instance, placed.positions[triangle[i]]);
                for (const std::uint32_t point : mesh.faces[face].vertices)
                    if (mesh.p_world[point] == p) corners[point] = 3 * t + i;
            }
            ++t;
        }
    }
    return corners;
}

/// From which sides of a face its surface goes on flat over an edge of many, to the next face round
/// that edge: 1 its front, 2 its back. Faces that lie on it are left out, as walks leave them.
std::uint32_t flat_sides(const LookupMesh& mesh,
                         std::uint32_t face,
                         std::size_t edge,
                         double crease_rad) {
    const auto& v = mesh.faces[face].vertices;
    const std::uint32_t low = std::min(v[edge], v[(edge + 1) % 3]),
                        high = std::max(v[edge], v[(edge + 1) % 3]);
    const glm::dvec3 a = mesh.p_world[v[edge]];
    const auto third = [&](std::uint32_t f) {
        const auto& [i, j, k] = mesh.faces[f].vertices;
        return mesh.p_world[i ^ j ^ k ^ low ^ high] - a;
    };
    const glm::dvec3 axis = glm::normalize(mesh.p_world[v[(edge + 1) % 3]] - a);
    const glm::dvec3 up = glm::normalize(glm::cross(axis, third(face))),
                     along = glm::cross(up, axis);
    double least_rad = 2 * std::numbers::pi, most_rad = 0;
    for (auto at = std::ranges::lower_bound(mesh.many, ManyFaces{low, high, 0});
         at != mesh.many.end() && at->a == low && at->b == high;
         ++at) {
        const double height = glm::dot(up, third(at->face)),
                     reach = glm::dot(along, third(at->face));
        if (reach > 0 && std::abs(height) <= mesh.tolerance_world[mesh.objects[face]]) continue;
        const double turn_rad = std::numbers::pi + std::atan2(-height, -reach);
        least_rad = std::min(least_rad, turn_rad);
        most_rad = std::max(most_rad, turn_rad);
    }
    const auto is_flat = [&](double rad) { return std::abs(rad - std::numbers::pi) < crease_rad; };
    return (is_flat(least_rad) ? 1U : 0U) | (is_flat(most_rad) ? 2U : 0U);
}

}  // namespace

std::vector<std::uint32_t> lookup_words(const LookupMesh& mesh,
                                        const std::vector<std::uint32_t>& codes) {
    const std::size_t count = mesh.faces.size();
    std::vector<std::uint32_t> words(count);
    for (std::size_t t = 0; t < codes.size(); ++t) {
        const std::uint32_t face = mesh.face_of_triangle[t];
        if (face != kNoNeighbour) words[face] = codes[t] << LookupWord::kCodeShift | face;
    }
    const auto code = [&](std::size_t face) {
        return static_cast<int>(words[face] >> LookupWord::kCodeShift);
    };
    for (std::size_t f = 0; f < count; ++f) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Twin twin = mesh.faces[f].twins[i];
            if (twin.is_nothing()) continue;
            const bool is_line = mesh.faces[f].kinds[i] != LineKind::none;
            if (twin.is_many() || is_line != (std::abs(code(f) - code(twin.face())) >= 2))
                words[f] |= LookupWord::kFlag;
        }
    }
    return words;
}

LookupTable lookup_table(const scene::PreparedScene& scene, double crease_deg) {
    const LookupParams params{.crease_deg = crease_deg};
    const double crease_rad = glm::radians(params.crease_deg);
    const LookupMesh mesh =
        make_lookup_mesh(scene, {.crease_rad = crease_rad, .weld_epsilon = params.weld_epsilon});
    LookupWord::require_room("surface_lookup", mesh.faces.size());
    const std::vector<std::uint32_t> words = lookup_words(mesh, lookup_codes(scene, params));

    LookupTable table;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const LookupFace& face = mesh.faces[f];
        std::uint32_t rest =
            (words[f] & ~LookupWord::kFaceOfCoded) | (mesh.objects[f] & LookupTable::kObject) << 9U;
        for (std::size_t i = 0; i < 3; ++i)
            rest |= (face.twins[i].is_many()
                         ? flat_sides(mesh, static_cast<std::uint32_t>(f), i, crease_rad)
                         : static_cast<std::uint32_t>(face.kinds[i]))
                    << 3 * i;
        table.faces.push_back({face.vertices,
                               face.patch,
                               {face.twins[0].word, face.twins[1].word, face.twins[2].word},
                               rest});
    }
    for (const glm::dvec3& p : mesh.p_world)
        table.p_world.emplace_back(p, 1);
    table.corners = corners_at_points(scene, mesh);
    return table;
}

}  // namespace ink::methods
