#include "shade/tones.h"
#include "core/disjoint_sets.h"
#include "scene/topology.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ink::shade {
namespace {

/// Sums weighted by area: of what a spot is made.
struct PatchSum {
    glm::dvec3 p_world{0};
    glm::dvec3 n_world{0};
    double area = 0;
};

UniformSpots::Spot to_spot(const PatchSum& sum) {
    UniformSpots::Spot spot;
    if (sum.area > 0) spot.p_world = sum.p_world / sum.area;
    const double length = glm::length(sum.n_world);
    if (length > 0) spot.n_world = sum.n_world / length;
    return spot;
}

void add_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, PatchSum& sum) {
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double area = glm::length(n);
    sum.p_world += area / 3 * (a + b + c);
    sum.n_world += n;
    sum.area += area;
}

}  // namespace

double reach(const scene::OmniLight& lamp, double distance) {
    return lamp.range > 0 ? std::max(0.0, 1 - distance / lamp.range) : 1;
}

glm::vec3 light_at(const glm::dvec3& p_world,
                   const glm::dvec3& n_world,
                   std::span<const scene::OmniLight> lamps,
                   const glm::vec3& ambient) {
    glm::vec3 light = ambient;
    for (const scene::OmniLight& lamp : lamps) {
        const glm::dvec3 to_lamp = lamp.p_world - p_world;
        const double distance = glm::length(to_lamp);
        if (distance == 0) continue;  // it shines from within the surface, in no direction
        const double cosine = std::max(0.0, glm::dot(n_world, to_lamp) / distance);
        light += lamp.color * static_cast<float>(cosine * reach(lamp, distance));
    }
    return light;
}

std::vector<scene::OmniLight> studio_lamps(const scene::Camera& camera,
                                           const scene::Sphere& bounds) {
    const glm::dmat3 world_from_view = glm::transpose(camera.view_from_world);
    const double r = bounds.radius > 0 ? bounds.radius : 1;
    const auto beside = [&](double right, double up, double back) {
        return bounds.center_world + world_from_view * (r * glm::dvec3(right, up, back));
    };
    return {{.p_world = beside(-1.5, 2, 2.5), .color = {0.75F, 0.74F, 0.7F}, .range = 0},
            {.p_world = beside(1.8, 0.3, 0.8), .color = {0.3F, 0.45F, 0.7F}, .range = 2.4 * r},
            {.p_world = beside(-0.4, -1.6, 0.6), .color = {0.7F, 0.4F, 0.3F}, .range = 2 * r}};
}

Tone tone_at(const glm::dvec3& p_world,
             const glm::dvec3& n_world,
             std::span<const scene::OmniLight> lamps,
             const glm::vec3& ambient) {
    Tone tone{light_at(p_world, n_world, lamps, ambient), 0};
    if (lamps.empty()) return tone;
    const glm::dvec3 to_key = lamps.front().p_world - p_world;
    const double distance = glm::length(to_key);
    if (distance > 0) tone.cosine = static_cast<float>(glm::dot(n_world, to_key) / distance);
    return tone;
}

float brightness(const glm::vec3& light) {
    return std::clamp(0.299F * light.r + 0.587F * light.g + 0.114F * light.b, 0.0F, 1.0F);
}

SurfaceTones make_tones(const scene::Surface& surface,
                        const UniformSpots& spots,
                        std::span<const scene::OmniLight> lamps,
                        const glm::vec3& ambient) {
    SurfaceTones tones;
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1 : -1;
        tones.vertices[side].reserve(surface.p_world.size());
        for (std::size_t i = 0; i < surface.p_world.size(); ++i) {
            tones.vertices[side].push_back(
                tone_at(surface.p_world[i], sign * glm::dvec3(surface.n_world[i]), lamps, ambient));
        }
        tones.spots[side].reserve(spots.spots.size());
        for (const UniformSpots::Spot& spot : spots.spots)
            tones.spots[side].push_back(tone_at(spot.p_world, sign * spot.n_world, lamps, ambient));
    }
    return tones;
}

UniformSpots face_spots(const scene::Surface& surface) {
    UniformSpots result;
    for (const auto& [a, b, c] : surface.triangles) {
        PatchSum sum;
        add_triangle(surface.p_world[a], surface.p_world[b], surface.p_world[c], sum);
        result.of.push_back(static_cast<std::uint32_t>(result.spots.size()));
        result.spots.push_back(to_spot(sum));
    }
    return result;
}

UniformSpots patch_spots(const scene::Scene& scene, double crease_rad) {
    const scene::Topology topology = scene::weld(scene);
    core::DisjointSets groups(topology.faces.size());
    std::vector<std::uint32_t> smooth;  // a face at each edge beyond which the surface bends on
    for (const scene::Edge& edge : topology.edges) {
        if (edge.face_count != 2 || !is_consistent(topology, edge)) continue;
        const auto faces = topology.faces_of(edge);
        const double deviation = scene::deviation_rad(topology, edge, faces[0], faces[1]);
        if (deviation < kFlat_rad) {
            groups.join(faces[0], faces[1]);
        } else if (deviation < crease_rad) {
            smooth.insert(smooth.end(), faces.begin(), faces.end());
        }
    }
    std::vector<bool> is_curved(topology.faces.size());
    for (const std::uint32_t face : smooth)
        is_curved[groups.root(face)] = true;

    UniformSpots result;
    result.of.assign(scene::triangle_count(scene), UniformSpots::kNone);
    std::vector<std::uint32_t> patch_of(topology.faces.size(), UniformSpots::kNone);
    std::vector<PatchSum> sums;
    for (std::uint32_t i = 0; i < topology.faces.size(); ++i) {
        const std::uint32_t root = groups.root(i);
        if (is_curved[root]) continue;
        if (patch_of[root] == UniformSpots::kNone) {
            patch_of[root] = static_cast<std::uint32_t>(sums.size());
            sums.emplace_back();
        }
        const scene::Face& face = topology.faces[i];
        const auto& p = topology.p_world;
        add_triangle(
            p[face.vertices[0]], p[face.vertices[1]], p[face.vertices[2]], sums[patch_of[root]]);
        result.of[face.triangle] = patch_of[root];
    }
    for (const PatchSum& sum : sums)
        result.spots.push_back(to_spot(sum));
    return result;
}

}  // namespace ink::shade
