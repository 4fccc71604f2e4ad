#include <algorithm>
#include <cassert>
#include <numeric>

#include "catalogue/shapes.h"

// Ear clipping (Meisters 1975, "Polygons have ears"): cut off a convex corner that holds no other
// corner, until three are left. Cubic at worst, for outlines of a few dozen points.

namespace ink::catalogue {
namespace {

using Outline = std::span<const glm::dvec2>;

/// Twice the signed area of (a, b, c): positive where it turns left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_ear(Outline outline,
            const std::vector<std::uint32_t>& left,
            const scene::Triangle& corner) {
    const std::uint32_t a = corner[0], b = corner[1], c = corner[2];
    if (turn(outline[a], outline[b], outline[c]) <= 0) return false;
    return std::none_of(left.begin(), left.end(), [&](std::uint32_t i) {
        if (i == a || i == b || i == c) return false;
        const auto& p = outline[i];
        return turn(outline[a], outline[b], p) >= 0 && turn(outline[b], outline[c], p) >= 0 &&
               turn(outline[c], outline[a], p) >= 0;
    });
}

/// Cuts off the first ear and returns it.
scene::Triangle cut_ear(Outline outline, std::vector<std::uint32_t>& left) {
    const std::size_t count = left.size();
    for (std::size_t i = 0; i < count; ++i) {
        const scene::Triangle corner{left[(i + count - 1) % count], left[i], left[(i + 1) % count]};
        if (!is_ear(outline, left, corner)) continue;
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        return corner;
    }
    assert(!"the outline crosses itself or runs clockwise");
    left.clear();
    return {};
}

}  // namespace

scene::Mesh extrude(std::span<const glm::dvec2> outline, glm::dvec2 z) {
    Ring back;
    Ring front;
    for (const auto& p : outline) {
        back.emplace_back(p, z.x);
        front.emplace_back(p, z.y);
    }
    const Ring rings[] = {back, front};
    scene::Mesh mesh = loft(rings);
    const auto count = static_cast<std::uint32_t>(outline.size());
    std::vector<std::uint32_t> left(count);
    std::iota(left.begin(), left.end(), 0U);
    while (left.size() > 2) {
        const auto [a, b, c] = cut_ear(outline, left);
        mesh.triangles.push_back({count + a, count + b, count + c});
        mesh.triangles.push_back({c, b, a});
    }
    return mesh;
}

}  // namespace ink::catalogue
