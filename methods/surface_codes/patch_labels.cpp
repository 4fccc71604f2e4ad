#include "methods/surface_codes/patch_labels.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace ink::methods {
namespace {

constexpr std::uint32_t kUnknown = 0xffffffffU;
/// Labels that a patch looks at: all of a byte's, and as many of 16 bits.
constexpr std::uint32_t kTried = 256;

}  // namespace

PatchBorders::PatchBorders(const SmoothMesh& mesh)
    : KeyedLists(mesh.patch_count, [&](auto take) {
          for (const FacePair& pair : mesh.borders) {
              const scene::Edge& edge = mesh.topology.edges[pair.edge];
              const double length =
                  glm::length(mesh.topology.p_world[edge.a] - mesh.topology.p_world[edge.b]);
              take(mesh.patch_of[pair.face0], BorderSide{pair.face0, pair.face1, length});
              take(mesh.patch_of[pair.face1], BorderSide{pair.face1, pair.face0, length});
          }
      }) {}

std::vector<std::uint32_t> patches_by_area(const SmoothMesh& mesh) {
    std::vector<double> areas(mesh.patch_count, 0);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        areas[mesh.patch_of[f]] += glm::length(mesh.topology.area_vector(f));
    std::vector<std::uint32_t> order(mesh.patch_count);
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order,
                             [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
    return order;
}

std::uint32_t scattered(std::uint32_t patch, std::uint32_t count) {
    const std::uint32_t share = patch * 2654435769U;
    return static_cast<std::uint32_t>(std::uint64_t{share} * count >> 32);
}

int seen_difference(std::uint32_t a, std::uint32_t b, int bits) {
    const std::uint32_t mask = (1U << bits) - 1;
    std::uint32_t least = mask;
    for (std::uint32_t m = 1; m <= 3; ++m) {
        const std::uint32_t there = (m * (a - b)) & mask, back = (m * (b - a)) & mask;
        least = std::min({least, there, back});
    }
    return static_cast<int>(least);
}

std::vector<std::uint32_t> patch_labels(const SmoothMesh& mesh, const LabelRange& range) {
    assert(range.bits >= 1 && range.bits <= 16);
    const std::uint32_t count = 1U << range.bits;
    const PatchBorders borders(mesh);
    std::vector<std::uint32_t> labels(mesh.patch_count, kUnknown);
    for (const std::uint32_t patch : patches_by_area(mesh)) {
        const std::uint32_t start = scattered(patch, count);
        double least = -1;
        for (std::uint32_t i = 0; i < std::min(count, kTried) && least != 0; ++i) {
            // Steps of an odd number near the golden section of the range: all of it, far apart.
            const std::uint32_t label = (start + i * (count * 5 / 8 | 1U)) % count;
            double lost = 0;
            for (const BorderSide& side : borders.of(patch)) {
                const std::uint32_t other = labels[mesh.patch_of[side.beyond]];
                if (other == kUnknown) continue;
                if (seen_difference(label, other, range.bits) < range.least_difference)
                    lost += side.length;
            }
            if (least >= 0 && lost >= least) continue;
            least = lost;
            labels[patch] = label;
        }
    }
    std::vector<std::uint32_t> of_faces(mesh.face_count());
    for (std::size_t f = 0; f < of_faces.size(); ++f)
        of_faces[f] = labels[mesh.patch_of[f]];
    return of_faces;
}

}  // namespace ink::methods
