#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "catalogue/shapes.h"

namespace ink::catalogue {
namespace {

/// The plane of one ring: `u` x `v` points along the path.
struct Frame {
    glm::dvec3 u;
    glm::dvec3 v;
};

/// `u` with its part along `direction` taken out, and the axis that completes it.
Frame frame_across(const glm::dvec3& direction, const glm::dvec3& u) {
    const glm::dvec3 across = glm::normalize(u - direction * glm::dot(direction, u));
    return {across, glm::cross(direction, across)};
}

Frame first_frame(const glm::dvec3& direction) {
    const bool is_upright = std::abs(direction.y) > 0.9;
    return frame_across(direction, is_upright ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
}

Frame turned(const Frame& frame, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return {frame.u * c + frame.v * s, frame.v * c - frame.u * s};
}

Ring ring_at(const TubeNode& node, const Frame& frame, const Ring& circle) {
    Ring ring;
    for (const auto& p : circle) {
        ring.push_back(node.center + (frame.u * p.x - frame.v * p.z) * node.radius);
    }
    return ring;
}

// Ear clipping (Meisters 1975, "Polygons have ears"): cut off a convex corner that holds no other
// corner, until three are left. Cubic at worst, for outlines of a few dozen points.

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

std::vector<TubeNode> smoothed(std::span<const TubeNode> path, int cuts) {
    assert(path.size() >= 2);
    const auto node = [&](std::size_t i) {  // the ends are doubled
        return path[std::clamp<std::size_t>(i, 1, path.size()) - 1];
    };
    const auto blend = [](const auto& a, const auto& b, const auto& c, const auto& d, double t) {
        return b + (c - a) * (0.5 * t) + (a * 2.0 - b * 5.0 + c * 4.0 - d) * (0.5 * t * t) +
               ((b - c) * 3.0 + d - a) * (0.5 * t * t * t);
    };
    std::vector<TubeNode> result;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const TubeNode nodes[] = {node(i), node(i + 1), node(i + 2), node(i + 3)};
        for (int k = 0; k < cuts; ++k) {
            const double t = double(k) / cuts;
            const auto& [a, b, c, d] = nodes;
            result.push_back({blend(a.center, b.center, c.center, d.center, t),
                              blend(a.radius, b.radius, c.radius, d.radius, t)});
        }
    }
    result.push_back(path.back());
    return result;
}

scene::Mesh make_tube(std::span<const TubeNode> path, int segments) {
    assert(path.size() >= 2);
    const Ring circle = unit_circle(segments);
    const std::size_t last = path.size() - 1;
    std::vector<Ring> rings{{path[0].center}};
    Frame frame = first_frame(glm::normalize(path[1].center - path[0].center));
    for (std::size_t i = 0; i <= last; ++i) {
        const auto& from = path[i == 0 ? 0 : i - 1].center;
        const auto& to = path[i == last ? last : i + 1].center;
        frame = frame_across(glm::normalize(to - from), frame.u);
        rings.push_back(ring_at(path[i], frame, circle));
    }
    rings.push_back({path[last].center});
    return loft(rings);
}

scene::Mesh make_closed_tube(std::span<const TubeNode> path, int segments) {
    const Ring circle = unit_circle(segments);
    const std::size_t count = path.size();
    const auto direction = [&](std::size_t i) {
        return glm::normalize(path[(i + 1) % count].center - path[(i + count - 1) % count].center);
    };
    std::vector<Frame> frames{first_frame(direction(0))};
    for (std::size_t i = 1; i <= count; ++i) {
        frames.push_back(frame_across(direction(i % count), frames.back().u));
    }
    const glm::dvec3& end = frames[count].u;
    const double twist_rad = std::atan2(glm::dot(end, frames[0].v), glm::dot(end, frames[0].u));
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count);
        rings.push_back(ring_at(path[i], turned(frames[i], -twist_rad * share), circle));
    }
    return loft(rings, {.along = true});
}

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
