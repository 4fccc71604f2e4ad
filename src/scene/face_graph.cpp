#include "scene/face_graph.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/disjoint_sets.h"
#include "core/keyed_lists.h"
#include "core/numbering.h"
#include "scene/predicates.h"

namespace ink::scene {
namespace {

constexpr std::uint32_t kFree = 0xffffffffU;

/// Fills `graph.places` and `graph.corner_at`.
///
/// A corner may serve two objects that touch; it is then at a place of either.
void number_places(const Surface& surface, FaceGraph& graph) {
    core::Numbering<std::array<double, 4>> places(surface.p_world.size());
    places.keys().reserve(surface.p_world.size());
    std::vector<std::uint32_t> last_object(surface.p_world.size(), kFree);
    std::vector<std::uint32_t> last_place(surface.p_world.size());
    graph.places.reserve(surface.triangles.size() * 3);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const std::uint32_t object = surface.object[t];
        for (const std::uint32_t corner : surface.triangles[t]) {
            if (last_object[corner] != object) {
                last_object[corner] = object;
                const glm::dvec3 p = surface.p_world[corner] + 0.0;  // -0 and 0 must hash alike
                const auto [place, is_new] =
                    places.insert({p.x, p.y, p.z, static_cast<double>(object)});
                if (is_new) graph.corner_at.push_back(corner);
                last_place[corner] = place;
            }
            graph.places.push_back(last_place[corner]);
        }
    }
}

/// The side of a triangle from corner side % 3 of triangle side / 3 to the next, filed under the
/// lower of its two places.
struct Side {
    std::uint32_t upper_place;
    std::uint32_t side;
};

std::uint32_t end_of(std::uint32_t side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

/// Sides of all triangles with three distinct places, by the lower of their two.
core::KeyedLists<Side> sides_by_place(const FaceGraph& graph) {
    const std::vector<std::uint32_t>& places = graph.places;
    return {graph.corner_at.size(), [&](auto take) {
                for (std::uint32_t t = 0; t < places.size(); t += 3) {
                    const std::uint32_t* p = places.data() + t;
                    if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
                    for (std::uint32_t side = t; side < t + 3; ++side) {
                        const auto [lower, upper] = std::minmax(places[side], places[end_of(side)]);
                        take(lower, Side{upper, side});
                    }
                }
            }};
}

/// Calls `visit(begin, end)` with the sides of each edge.
template <class Visit>
void for_each_edge(const FaceGraph& graph, const Visit& visit) {
    core::KeyedLists<Side> lists = sides_by_place(graph);
    for (std::size_t place = 0; place < lists.key_count(); ++place) {
        const std::span<Side> sides = lists.of(place);
        std::ranges::sort(sides, [](const Side& a, const Side& b) {
            return a.upper_place != b.upper_place ? a.upper_place < b.upper_place : a.side < b.side;
        });
        Side* const last = sides.data() + sides.size();
        for (Side* begin = sides.data(); begin != last;) {
            Side* const end = std::find_if(
                begin, last, [&](const Side& s) { return s.upper_place != begin->upper_place; });
            visit(begin, end);
            begin = end;
        }
    }
}

/// Whether each triangle has an area.
std::vector<bool> find_areas(const Surface& surface, const FaceGraph& graph) {
    std::vector<bool> has_area(surface.triangles.size());
    for (std::size_t t = 0; t < has_area.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        const std::uint32_t* p = graph.places.data() + 3 * t;
        has_area[t] = p[0] != p[1] && p[1] != p[2] && p[2] != p[0] &&
                      !is_collinear(surface.p_world[a], surface.p_world[b], surface.p_world[c]);
    }
    return has_area;
}

/// Triangles at an edge that a closed surface does not have, and those at one that is no rim
/// either.
struct OpenEdges {
    std::vector<bool> is_open;
    std::vector<bool> is_no_rim;
};

/// Fills `across` and `rim_sides`.
OpenEdges join_edges(const std::vector<bool>& has_area, FaceGraph& graph) {
    OpenEdges edges{std::vector<bool>(has_area.size(), false),
                    std::vector<bool>(has_area.size(), false)};
    for (std::uint32_t side = 0; side < graph.places.size(); ++side)
        graph.across.push_back(side / 3);
    for_each_edge(graph, [&](Side* begin, Side* end) {
        // A triangle without area may close the gap beside it or not: taken as if it did not.
        Side* const last =
            std::stable_partition(begin, end, [&](const Side& s) { return has_area[s.side / 3]; });
        const bool is_closed = end - begin == 2 && last == end &&
                               graph.places[begin[0].side] != graph.places[begin[1].side];
        for (Side* s = begin; s != last; ++s) {
            graph.across[s->side] = (s + 1 == last ? begin : s + 1)->side / 3;
            if (is_closed) continue;
            edges.is_open[s->side / 3] = true;
            if (end - begin > 1) {
                edges.is_no_rim[s->side / 3] = true;
            } else {
                graph.rim_sides.push_back(s->side);
            }
        }
    });
    return edges;
}

void number_solids(const std::vector<bool>& has_area, const OpenEdges& edges, FaceGraph& graph) {
    core::DisjointSets solids(has_area.size());
    // The triangles of a ring ascend but for one step.
    for (std::uint32_t side = 0; side < graph.across.size(); ++side)
        if (graph.across[side] > side / 3) solids.join(side / 3, graph.across[side]);
    for (std::uint32_t t = 0; t < has_area.size(); ++t) {
        std::uint32_t solid = FaceGraph::kNoSolid;
        if (has_area[t]) {
            const std::uint32_t first = solids.root(t);
            if (first == t) {
                graph.is_closed.push_back(true);
                graph.has_rims_only.push_back(true);
            }
            solid = first == t ? static_cast<std::uint32_t>(graph.is_closed.size() - 1)
                               : graph.solid_of[first];
            if (edges.is_open[t]) graph.is_closed[solid] = false;
            if (edges.is_no_rim[t]) graph.has_rims_only[solid] = false;
        }
        graph.solid_of.push_back(solid);
    }
}

}  // namespace

FaceGraph make_face_graph(const Surface& surface) {
    FaceGraph graph;
    number_places(surface, graph);
    const std::vector<bool> has_area = find_areas(surface, graph);
    number_solids(has_area, join_edges(has_area, graph), graph);
    return graph;
}

}  // namespace ink::scene
