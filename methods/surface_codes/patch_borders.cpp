#include "methods/surface_codes/patch_borders.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

namespace ink::methods {

PatchBorders::PatchBorders(const SmoothMesh& mesh) : first_(mesh.patch_count + std::size_t{1}, 0) {
    for (const FacePair& pair : mesh.borders) {
        ++first_[mesh.patch_of[pair.face0] + std::size_t{1}];
        ++first_[mesh.patch_of[pair.face1] + std::size_t{1}];
    }
    for (std::size_t p = 0; p < mesh.patch_count; ++p)
        first_[p + 1] += first_[p];
    sides_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const FacePair& pair : mesh.borders) {
        const scene::Edge& edge = mesh.topology.edges[pair.edge];
        const double length =
            glm::length(mesh.topology.p_world[edge.a] - mesh.topology.p_world[edge.b]);
        sides_[next[mesh.patch_of[pair.face0]]++] = {pair.face0, pair.face1, length};
        sides_[next[mesh.patch_of[pair.face1]]++] = {pair.face1, pair.face0, length};
    }
}

std::vector<std::uint32_t> patches_by_area(const SmoothMesh& mesh) {
    std::vector<double> areas(mesh.patch_count, 0);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto& [a, b, c] = mesh.topology.faces[f].vertices;
        const auto& p = mesh.topology.p_world;
        areas[mesh.patch_of[f]] += glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
    }
    std::vector<std::uint32_t> order(mesh.patch_count);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return areas[a] > areas[b];
    });
    return order;
}

std::uint32_t scattered(std::uint32_t patch, std::uint32_t count) {
    const std::uint32_t share = patch * 2654435769U;
    return static_cast<std::uint32_t>(std::uint64_t{share} * count >> 32);
}

}  // namespace ink::methods
