#include "scene/components.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <tuple>

#include "core/disjoint_sets.h"
#include "scene/predicates.h"

namespace ink::scene {
namespace {

/// What a component is judged by.
struct Tally {
    double six_volumes = 0;
    std::size_t edges = 0;
    std::size_t vertices = 0;
    bool is_bent_inwards = false;
};

/// Whether the second face of the edge rises before the first.
bool is_concave(const Topology& topology, const Edge& edge) {
    const auto faces = topology.faces_of(edge);
    if (deviation_rad(topology, edge, faces[0], faces[1]) < kFlat_rad) return false;
    const Face& face = topology.faces[faces[0]];
    const Face& other = topology.faces[faces[1]];
    const auto& p = topology.p_world;
    for (const std::uint32_t v : other.vertices) {
        if (v == edge.a || v == edge.b) continue;
        return facing(p[face.vertices[0]], p[face.vertices[1]], p[face.vertices[2]], p[v]) > 0;
    }
    return false;
}

/// Faces that hang together over edges.
core::DisjointSets join_faces(const Topology& topology) {
    core::DisjointSets groups(topology.faces.size());
    for (const Edge& edge : topology.edges) {
        const auto faces = topology.faces_of(edge);
        for (const std::uint32_t face : faces)
            groups.join(faces[0], face);
    }
    return groups;
}

void add_face(const Topology& topology, const Face& face, Component& component, Tally& tally) {
    for (const std::uint32_t v : face.vertices)
        component.box_world.add(topology.p_world[v]);
    ++component.faces;
    // Seen from a point nearby, so that a small component far from the origin keeps its volume's
    // sign.
    const glm::dvec3 origin = topology.p_world[topology.faces.front().vertices[0]];
    const auto& [a, b, c] = face.vertices;
    tally.six_volumes +=
        glm::dot(topology.p_world[a] - origin,
                 glm::cross(topology.p_world[b] - origin, topology.p_world[c] - origin));
}

/// Widens the ball round a component whose box is known.
void reach(const Topology& topology, const Face& face, Component& component) {
    const glm::dvec3 centre = component.box_world.center();
    for (const std::uint32_t v : face.vertices)
        component.radius = std::max(component.radius, glm::length(topology.p_world[v] - centre));
}

void add_edge(const Topology& topology, const Edge& edge, Component& component, Tally& tally) {
    ++tally.edges;
    component.is_closed = component.is_closed && edge.face_count == 2;
    if (edge.face_count != 2) return;
    component.is_consistent = component.is_consistent && is_consistent(topology, edge);
    // One is enough, and the question is the dearest.
    tally.is_bent_inwards = tally.is_bent_inwards || is_concave(topology, edge);
}

/// Each vertex counts for every component that it belongs to.
void count_vertices(const Topology& topology,
                    const std::vector<std::uint32_t>& component_of,
                    std::vector<Tally>& tallies) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> uses;
    uses.reserve(3 * topology.faces.size());
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        for (const std::uint32_t v : topology.faces[f].vertices)
            uses.emplace_back(v, component_of[f]);
    }
    std::ranges::sort(uses);
    uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
    for (const auto& [vertex, component] : uses)
        ++tallies[component].vertices;
}

bool have_common_room(const Component& one, const Component& other) {
    const Box &a = one.box_world, &b = other.box_world;
    const glm::dvec3 apart = (a.low + a.high - b.low - b.high) * 0.5;
    if (glm::length(apart) >= one.radius + other.radius) return false;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = std::max(a.low[axis], b.low[axis]);
        const double high = std::min(a.high[axis], b.high[axis]);
        if (low > high) return false;
        if (low < high) continue;
        // Touching is no crossing, unless a flat component stands within the other.
        const auto stands_within = [&](const Box& flat, const Box& around) {
            return flat.low[axis] == flat.high[axis] && around.low[axis] < low &&
                   around.high[axis] > high;
        };
        if (!stands_within(a, b) && !stands_within(b, a)) return false;
    }
    return true;
}

}  // namespace

Components find_components(const Topology& topology) {
    Components found;
    std::size_t count = 0;
    std::tie(found.component_of, count) = join_faces(topology).numbers();
    const std::vector<std::uint32_t>& component_of = found.component_of;
    std::vector<Component>& components = found.components;
    components.assign(count, {.is_closed = true, .is_consistent = true});
    std::vector<Tally> tallies(count);
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        add_face(
            topology, topology.faces[f], components[component_of[f]], tallies[component_of[f]]);
    }
    for (std::size_t f = 0; f < topology.faces.size(); ++f)
        reach(topology, topology.faces[f], components[component_of[f]]);
    for (const Edge& edge : topology.edges) {
        const std::uint32_t component = component_of[topology.faces_of(edge)[0]];
        add_edge(topology, edge, components[component], tallies[component]);
    }
    count_vertices(topology, component_of, tallies);
    for (std::size_t i = 0; i < count; ++i) {
        Component& component = components[i];
        const Tally& tally = tallies[i];
        component.is_watertight =
            component.is_closed && component.is_consistent && tally.six_volumes > 0;
        const bool is_ball = tally.vertices + component.faces == tally.edges + 2;
        component.is_convex = component.is_watertight && is_ball && !tally.is_bent_inwards;
    }
    return found;
}

std::size_t count_overlapping_components(const std::vector<Component>& components,
                                         std::size_t most) {
    if (components.empty()) return 0;
    Box box;
    std::vector<const Component*> sorted;
    for (const Component& component : components) {
        box.add(component.box_world);
        sorted.push_back(&component);
    }
    // Swept along the longest way, on which the fewest boxes stand side by side.
    const glm::dvec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    std::ranges::sort(sorted, {}, [axis](const Component* c) { return c->box_world.low[axis]; });
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        for (std::size_t j = i + 1; j < sorted.size(); ++j) {
            if (sorted[j]->box_world.low[axis] > sorted[i]->box_world.high[axis]) break;
            pairs += have_common_room(*sorted[i], *sorted[j]);
            if (pairs == most) return pairs;
        }
    }
    return pairs;
}

}  // namespace ink::scene
