#include "truth/crossings/continuation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/equal_rows.h"
#include "core/parallel.h"
#include "scene/box.h"
#include "truth/crossings/pair_tree.h"
#include "truth/crossings/pierce.h"

namespace ink::truth {
namespace {

constexpr double kShortestStretch = 8;  ///< tolerances
constexpr std::size_t kChunk = 1024;    ///< faces a task

/// A boundary edge and the only face it has.
struct Border {
    std::uint32_t edge = 0;
    std::uint32_t face = 0;
    glm::dvec3 a, b;
    glm::dvec3 along;   ///< unit, from a to b
    glm::dvec3 inward;  ///< unit, into the face, orthogonal to the edge
    double length = 0;
    double tolerance = 0;
};

std::vector<Border> list_borders(const scene::Topology& topology,
                                 std::span<const double> tolerances) {
    std::vector<Border> borders;
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
        const scene::Edge& edge = topology.edges[e];
        if (edge.face_count != 1) continue;
        Border border;
        border.edge = e;
        border.face = topology.faces_of(edge)[0];
        border.a = topology.p_world[edge.a];
        border.b = topology.p_world[edge.b];
        border.length = glm::length(border.b - border.a);
        border.tolerance = tolerances[topology.faces[border.face].object];
        if (border.length <= kShortestStretch * border.tolerance) continue;
        border.along = (border.b - border.a) / border.length;
        const std::uint32_t opposite = opposite_vertex(topology.faces[border.face], edge);
        const glm::dvec3 to_opposite = topology.p_world[opposite] - border.a;
        border.inward =
            glm::normalize(to_opposite - border.along * glm::dot(border.along, to_opposite));
        borders.push_back(border);
    }
    return borders;
}

std::vector<scene::Box> boxes_of(const std::vector<Border>& borders) {
    std::vector<scene::Box> boxes(borders.size());
    for (std::size_t i = 0; i < borders.size(); ++i) {
        for (const glm::dvec3& p : {borders[i].a, borders[i].b}) {
            boxes[i].add(p - borders[i].tolerance);
            boxes[i].add(p + borders[i].tolerance);
        }
    }
    return boxes;
}

/// Parameters of an edge, 0..1.
struct Stretch {
    double begin = 0;
    double end = 1;

    /// Keeps the part where at_begin + t (at_end - at_begin) >= 0.
    void keep_positive(double at_begin, double at_end) {
        if (at_begin >= 0 && at_end >= 0) return;
        if (at_begin < 0 && at_end < 0) {
            end = begin - 1;
            return;
        }
        const double root = at_begin / (at_begin - at_end);
        if (at_begin < 0) {
            begin = std::max(begin, root);
        } else {
            end = std::min(end, root);
        }
    }
};

struct Triangle {
    std::array<glm::dvec3, 3> p;
    glm::dvec3 normal;  ///< unit
};

/// Where the edge runs within the tolerance of the triangle's plane and its points, moved a little
/// along `into`, lie inside it.
Stretch shared_stretch(const Border& border, const Triangle& triangle, const glm::dvec3& into) {
    const double tolerance = border.tolerance;
    Stretch stretch;
    const auto height = [&](const glm::dvec3& p) {
        return glm::dot(triangle.normal, p - triangle.p[0]);
    };
    const double height_a = height(border.a), height_b = height(border.b);
    stretch.keep_positive(tolerance - height_a, tolerance - height_b);
    stretch.keep_positive(tolerance + height_a, tolerance + height_b);
    // Two tolerances: a face whose border lies within one of the edge then holds the point, and one
    // that ends at the edge from the same side as the edge's own face does not.
    const glm::dvec3 a = border.a + 2 * tolerance * into;
    const glm::dvec3 b = border.b + 2 * tolerance * into;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 side = triangle.p[(i + 1) % 3] - triangle.p[i];
        const glm::dvec3 inward = glm::cross(triangle.normal, side);
        stretch.keep_positive(glm::dot(inward, a - triangle.p[i]),
                              glm::dot(inward, b - triangle.p[i]));
    }
    return stretch;
}

/// How the triangle continues the face at the border, if it does.
std::optional<Continuation> continuation(const Border& border,
                                         const Triangle& triangle,
                                         const ContinuationOptions& options) {
    const glm::dvec3 across = glm::cross(triangle.normal, border.along);
    const double sine = glm::length(across);
    // The edge pierces the triangle steeply: they share a point, not a stretch. (Nor does a
    // triangle so thin that its normal is not a number.)
    if (!(sine >= 0.5)) return std::nullopt;
    for (const double sign : {1.0, -1.0}) {
        const glm::dvec3 into = across * (sign / sine);
        const double cosine = glm::dot(border.inward, into);
        const double deviation =
            std::acos(-1.0) - std::atan2(glm::length(glm::cross(border.inward, into)), cosine);
        if (deviation >= options.crease_rad) continue;
        const Stretch s = shared_stretch(border, triangle, into);
        if (s.end <= s.begin) continue;
        const auto gap = [&](double t) {
            return distance_to_triangle(border.a + t * (border.b - border.a), triangle.p);
        };
        return Continuation{.edge = border.edge,
                            .t_begin = s.begin,
                            .t_end = s.end,
                            .gap_begin_world = gap(s.begin),
                            .gap_end_world = gap(s.end),
                            .into_world = into};
    }
    return std::nullopt;
}

/// Takes away the stretches of one edge that, joined with those they touch, are no longer than a
/// contact at a corner. `begin` to `end` are the stretches of the edge in ascending order.
void keep_long_runs(std::vector<Continuation>::const_iterator begin,
                    std::vector<Continuation>::const_iterator end,
                    double shortest,
                    std::vector<Continuation>& kept) {
    while (begin != end) {
        double run_end = begin->t_end;
        auto next = begin + 1;
        for (; next != end && next->t_begin <= run_end + shortest / 2; ++next)
            run_end = std::max(run_end, next->t_end);
        if (run_end - begin->t_begin >= shortest) kept.insert(kept.end(), begin, next);
        begin = next;
    }
}

/// The same for all edges.
std::vector<Continuation> without_contacts(const scene::Topology& topology,
                                           const std::vector<Continuation>& sorted,
                                           std::span<const double> tolerances) {
    std::vector<Continuation> kept;
    for (auto begin = sorted.begin(); begin != sorted.end();) {
        auto end = begin;
        while (end != sorted.end() && end->edge == begin->edge)
            ++end;
        const scene::Edge& edge = topology.edges[begin->edge];
        const double length = glm::length(topology.p_world[edge.b] - topology.p_world[edge.a]);
        const std::uint32_t object = topology.faces[topology.faces_of(edge)[0]].object;
        keep_long_runs(begin, end, kShortestStretch * tolerances[object] / length, kept);
        begin = end;
    }
    return kept;
}

Triangle triangle_of(const scene::Topology& topology, const scene::Face& face) {
    Triangle t;
    for (std::size_t i = 0; i < 3; ++i)
        t.p[i] = topology.p_world[face.vertices[i]];
    t.normal = glm::normalize(glm::cross(t.p[1] - t.p[0], t.p[2] - t.p[0]));
    return t;
}

}  // namespace

std::vector<Continuation> find_continuations(const scene::Topology& topology,
                                             const ContinuationOptions& options) {
    const auto borders = list_borders(topology, options.tolerances);
    if (borders.empty()) return {};
    const std::vector<scene::Box> boxes = boxes_of(borders);
    const PairTree tree(boxes);
    using Found = std::vector<Continuation>;
    const auto search = [&](std::size_t begin, std::size_t end, Found& found) {
        for (std::size_t f = begin; f < end; ++f) {
            const Triangle triangle = triangle_of(topology, topology.faces[f]);
            const scene::Box box = scene::box_of(triangle.p);
            tree.for_each_near(box, [&](std::uint32_t i) {
                if (borders[i].face == f || !boxes[i].touches(box)) return;
                auto c = continuation(borders[i], triangle, options);
                if (!c) return;
                c->face = static_cast<std::uint32_t>(f);
                found.push_back(*c);
            });
        }
    };
    Found all;
    for (const auto& part :
         core::parallel_parts<Found>(topology.faces.size(), kChunk, options.threads, search))
        all.insert(all.end(), part.begin(), part.end());
    std::ranges::sort(all, {}, [](const auto& x) { return std::tie(x.edge, x.t_begin, x.face); });
    return without_contacts(topology, all, options.tolerances);
}

std::span<const Continuation> continuations_of(std::span<const Continuation> all,
                                               std::uint32_t edge) {
    return core::equal_rows(all, edge, &Continuation::edge);
}

}  // namespace ink::truth
