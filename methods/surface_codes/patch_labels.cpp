#include "methods/surface_codes/patch_labels.h"

#include <algorithm>
#include <cassert>

#include "methods/surface_codes/patch_borders.h"

namespace ink::methods {
namespace {

constexpr std::uint32_t kUnknown = 0xffffffffU;
/// Labels that a patch looks at: all of a byte's, and as many of 16 bits.
constexpr std::uint32_t kTried = 256;

}  // namespace

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
            for (const PatchBorders::Side& side : borders.of(patch)) {
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
