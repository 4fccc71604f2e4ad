#include "methods/strokes/segments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace ink::methods {
namespace {

constexpr double kFarOff_px = 0.75;  ///< from where walks found it to the line of two planes

/// Sample (x, y) is the centre of pixel (x, y) of the view.
glm::dvec2 place(const glm::dvec3& p_clip) {
    return glm::dvec2(p_clip.x, p_clip.y) / p_clip.z - 0.5;
}

/// 1/w over the image.
struct DepthPlane {
    double constant, per_x, per_y;

    [[nodiscard]] double at(const glm::dvec2& p) const {
        return constant + per_x * p.x + per_y * p.y;
    }
};

/// By the plane in clip space, where n p = d: 1/w = n (x, y, 1) / d.
std::optional<DepthPlane> depth_plane(const ScreenMesh& screen, std::uint32_t face) {
    const auto& v = screen.mesh().faces[face].vertices;
    const glm::dvec3 a = screen.p_clip(v[0]), b = screen.p_clip(v[1]), c = screen.p_clip(v[2]);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double d = glm::dot(n, a);
    if (!(std::abs(d) > 1e-300)) return std::nullopt;
    return DepthPlane{(n.z + 0.5 * (n.x + n.y)) / d, n.x / d, n.y / d};
}

}  // namespace

std::optional<Segment> edge_segment(const ScreenMesh& screen, std::uint32_t a, std::uint32_t b) {
    glm::dvec3 from = screen.p_clip(a), to = screen.p_clip(b);
    const double near = screen.near();
    if (from.z < near && to.z < near) return std::nullopt;
    if (from.z < near) from += (to - from) * ((near - from.z) / (to.z - from.z));
    if (to.z < near) to += (from - to) * ((near - to.z) / (from.z - to.z));
    return Segment{place(from), place(to), 1 / from.z, 1 / to.z};
}

std::optional<Segment> intersection_segment(const ScreenMesh& screen,
                                            std::uint32_t face,
                                            std::uint32_t other,
                                            const glm::dvec2& at) {
    if (face == kNoNeighbour || other == kNoNeighbour) return std::nullopt;
    const auto f = depth_plane(screen, face), g = depth_plane(screen, other);
    if (!f || !g) return std::nullopt;
    const glm::dvec2 across{f->per_x - g->per_x, f->per_y - g->per_y};
    const double length = glm::length(across);
    if (!(length > 0)) return std::nullopt;
    const double off = (f->at(at) - g->at(at)) / length;
    if (!(std::abs(off) <= kFarOff_px)) return std::nullopt;
    const glm::dvec2 n = across / length, on = at - off * n, along{-n.y, n.x};
    const glm::dvec2 a = on - 2.0 * along, b = on + 2.0 * along;
    return Segment{a, b, f->at(a), f->at(b)};
}

double plane_q(const ScreenMesh& screen, std::uint32_t face, const glm::dvec2& at) {
    const auto plane = depth_plane(screen, face);
    return plane ? plane->at(at) : 0;
}

std::optional<Clipped> clip_to_cell(const Segment& segment, const glm::ivec2& cell) {
    Clipped part;
    const glm::dvec2 way = segment.b - segment.a;
    for (int i = 0; i < 2; ++i) {
        const double low = cell[i] - segment.a[i], high = low + 1;
        if (std::abs(way[i]) < 1e-12) {
            if (low > 0 || high < 0) return std::nullopt;
            continue;
        }
        const double to_low = low / way[i], to_high = high / way[i];
        part.from = std::max(part.from, std::min(to_low, to_high));
        part.to = std::min(part.to, std::max(to_low, to_high));
    }
    if (!(part.from <= part.to)) return std::nullopt;
    return part;
}

}  // namespace ink::methods
