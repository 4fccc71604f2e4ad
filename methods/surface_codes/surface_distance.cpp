#include "methods/surface_codes/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "core/disjoint_sets.h"
#include "scene/box.h"

namespace ink::methods {
namespace {

/// A unit normal per face; those of one patch on the same side of it, whichever way its faces are
/// turned, as far as it has two sides. 0 where the area is too small for a double.
std::vector<glm::dvec3> patch_normals(const SmoothMesh& mesh) {
    const scene::Topology& topology = mesh.topology;
    std::vector<glm::dvec3> normals(mesh.face_count());
    for (std::uint32_t f = 0; f < normals.size(); ++f)
        normals[f] = scene::unit_or_zero(topology.area_vector(f));
    enum : std::uint8_t { unseen, as_it_is, flipped };
    std::vector<std::uint8_t> side(mesh.face_count(), unseen);
    std::vector<std::uint32_t> due;
    for (std::uint32_t first = 0; first < side.size(); ++first) {
        if (side[first] != unseen) continue;
        side[first] = as_it_is;
        due.push_back(first);
        while (!due.empty()) {
            const std::uint32_t f = due.back();
            due.pop_back();
            if (side[f] == flipped) normals[f] = -normals[f];
            for (std::uint32_t i = 0; i < 3; ++i) {
                const std::uint32_t g = mesh.across[3 * f + i];
                if (g == SmoothMesh::kNone || side[g] != unseen) continue;
                const scene::Edge& edge = topology.edges[topology.faces[f].edges[i]];
                const bool turns = scene::runs_forward(topology.faces[f], edge) ==
                                   scene::runs_forward(topology.faces[g], edge);
                side[g] = turns == (side[f] == as_it_is) ? flipped : as_it_is;
                due.push_back(g);
            }
        }
    }
    return normals;
}

/// How far the normals of a fan lie from their mean, as the largest distance between unit vectors,
/// per fan.
std::vector<double> fan_spreads(const SmoothMesh& mesh, const std::vector<glm::dvec3>& normals) {
    std::vector<glm::dvec3> means(mesh.fan_count, glm::dvec3(0));
    for (std::size_t corner = 0; corner < mesh.fan_of.size(); ++corner)
        means[mesh.fan_of[corner]] += normals[corner / 3];
    for (glm::dvec3& mean : means)
        mean = scene::unit_or_zero(mean);
    std::vector<double> spreads(mesh.fan_count, 0);
    for (std::size_t corner = 0; corner < mesh.fan_of.size(); ++corner) {
        double& spread = spreads[mesh.fan_of[corner]];
        spread = std::max(spread, glm::length(normals[corner / 3] - means[mesh.fan_of[corner]]));
    }
    return spreads;
}

/// What the size of a triangle says of the ways over it.
struct Extent {
    glm::dvec3 center{0};
    double width = 0;  ///< over its longest side: how far across it is where it is thin
};

Extent extent_of(const scene::Topology& topology, const scene::Face& face) {
    const auto p = [&](std::size_t i) { return topology.p_world[face.vertices[i]]; };
    const glm::dvec3 a = p(1) - p(0), b = p(2) - p(0), c = p(2) - p(1);
    const double longest = std::sqrt(std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)}));
    return {(p(0) + p(1) + p(2)) / 3.0, glm::length(glm::cross(a, b)) / longest};
}

/// Rounded down, but for what rounding of positions may leave below a whole number.
std::int32_t whole_cost(double steps) {
    constexpr double kSlack = 1e-6;
    return static_cast<std::int32_t>(std::min(steps, 1.0) * kStep + kSlack);
}

constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max() / 2;

/// The distances of all nodes from the nearest source.
std::vector<std::int32_t> distances_from(const SurfaceGraph& graph,
                                         const std::vector<std::uint32_t>& sources) {
    std::vector<std::int32_t> distances(graph.node_count(), kFar);
    for (const std::uint32_t source : sources)
        distances[source] = 0;
    spread(graph, sources, distances);
    return distances;
}

/// Each patch's face of the greatest distance, the first of equals.
std::vector<std::uint32_t> farthest_faces(const SmoothMesh& mesh,
                                          const std::vector<std::int32_t>& distances) {
    std::vector<std::uint32_t> farthest(mesh.patch_count, SmoothMesh::kNone);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        std::uint32_t& best = farthest[mesh.patch_of[f]];
        if (best == SmoothMesh::kNone || distances[f] > distances[best]) best = f;
    }
    return farthest;
}

/// Times that one side of a crease is lifted at most. Where creases stand so close that they can
/// not all be parted, lifting one undoes another for ever.
constexpr int kMostLifts = 3;

/// A crease inside a patch, as its two sides.
struct Slit {
    std::uint32_t down = 0;    ///< of the chain of the lower number, until sides are chosen
    std::uint32_t up = 0;      ///< this side is lifted
    std::uint64_t chains = 0;  ///< those two numbers
    int lifts = 0;             ///< so far
};

/// Whether there is a way between two faces that costs less than some steps: then no distance parts
/// them by as many.
class NearTest {
  public:
    explicit NearTest(const SurfaceGraph& graph) : graph_(graph), keys_(graph.node_count(), kFar) {}

    bool operator()(std::uint32_t from, std::uint32_t to, std::int32_t cost) {
        keys_[from] = 0;
        met_.assign(1, from);
        due_.assign(1, {0, from});
        while (!due_.empty() && keys_[to] >= cost) {
            std::pop_heap(due_.begin(), due_.end(), std::greater<>());
            const auto [key, node] = due_.back();
            due_.pop_back();
            if (key != keys_[node]) continue;
            graph_.for_each_way(node, [&, key = key](std::uint32_t next, std::int32_t more) {
                if (key + more >= std::min(keys_[next], cost)) return;
                keys_[next] = key + more;
                met_.push_back(next);
                due_.emplace_back(key + more, next);
                std::push_heap(due_.begin(), due_.end(), std::greater<>());
            });
        }
        const bool is_near = keys_[to] < cost;
        for (const std::uint32_t node : met_)
            keys_[node] = kFar;
        return is_near;
    }

  private:
    const SurfaceGraph& graph_;
    std::vector<std::int32_t> keys_;
    std::vector<std::uint32_t> met_;
    std::vector<std::pair<std::int32_t, std::uint32_t>> due_;
};

/// The creases inside patches.
std::vector<FacePair> inner_creases(const SmoothMesh& mesh) {
    std::vector<FacePair> inner;
    for (const FacePair& pair : mesh.borders) {
        if (mesh.patch_of[pair.face0] == mesh.patch_of[pair.face1]) inner.push_back(pair);
    }
    return inner;
}

/// Those of them that can be parted, those with the same chains of faces beside them together. A
/// chain is what is joined along creases over fans, so that a long crease is lifted on one side
/// alone.
std::vector<Slit> find_slits(const SmoothMesh& mesh, const SurfaceGraph& graph) {
    const std::vector<FacePair> inner = inner_creases(mesh);
    if (inner.empty()) return {};
    core::DisjointSets chains(graph.node_count());
    for (const FacePair& pair : inner) {
        const scene::Edge& edge = mesh.topology.edges[pair.edge];
        for (const std::uint32_t face : {pair.face0, pair.face1}) {
            for (const std::uint32_t vertex : {edge.a, edge.b}) {
                const std::uint32_t fan = mesh.fan_of[mesh.corner_at(face, vertex)];
                const auto node = static_cast<std::uint32_t>(graph.face_count()) + fan;
                if (!graph.is_slit_end(fan)) chains.join(face, node);
            }
        }
    }
    std::vector<Slit> slits;
    NearTest is_near(graph);
    for (const FacePair& pair : inner) {
        if (is_near(pair.face0, pair.face1, 2 * kStep)) continue;
        const std::uint64_t a = chains.root(pair.face0), b = chains.root(pair.face1);
        slits.push_back(a <= b ? Slit{pair.face0, pair.face1, a << 32 | b}
                               : Slit{pair.face1, pair.face0, b << 32 | a});
    }
    std::ranges::stable_sort(slits, {}, &Slit::chains);
    return slits;
}

bool is_parted(const Slit& slit, const std::vector<std::int32_t>& distances) {
    const std::int32_t down = distances[slit.down] / kStep, up = distances[slit.up] / kStep;
    return down - up >= 2 || up - down >= 2;
}

std::ptrdiff_t count_parted(const std::vector<Slit>& slits,
                            const std::vector<std::int32_t>& distances) {
    return std::ranges::count_if(slits, [&](const Slit& s) { return is_parted(s, distances); });
}

/// Which side of each slit is to be lifted: that whose chain leads over the other, all along; where
/// both sides are one chain, the higher.
void choose_sides(std::vector<Slit>& slits, const std::vector<std::int32_t>& distances) {
    const auto lead = [&](const Slit& slit) {
        return std::int64_t{distances[slit.up]} - distances[slit.down];
    };
    for (auto run = slits.begin(); run != slits.end();) {
        const auto end =
            std::find_if(run, slits.end(), [&](const Slit& s) { return s.chains != run->chains; });
        std::int64_t whole_lead = 0;
        for (auto slit = run; slit != end; ++slit)
            whole_lead += lead(*slit);
        const bool is_own_chain = run->chains >> 32 == (run->chains & 0xffffffffU);
        for (; run != end; ++run)
            if ((is_own_chain ? lead(*run) : whole_lead) < 0) std::swap(run->up, run->down);
    }
}

/// Lifts what is not parted yet. `keys` are distances below 0: lifting lowers them. Returns whether
/// there was anything to do.
bool lift(const SurfaceGraph& graph,
          std::vector<Slit>& slits,
          std::vector<std::int32_t>& distances) {
    std::vector<std::uint32_t> lifted;
    std::vector<std::int32_t> keys(distances.size());
    std::ranges::transform(distances, keys.begin(), [](std::int32_t d) { return -d; });
    for (Slit& slit : slits) {
        if (is_parted(slit, distances) || slit.lifts == kMostLifts) continue;
        ++slit.lifts;
        lifted.push_back(slit.up);
        keys[slit.up] = std::min(keys[slit.up], -(distances[slit.down] + 2 * kStep));
    }
    if (lifted.empty()) return false;
    std::ranges::sort(lifted);
    lifted.erase(std::unique(lifted.begin(), lifted.end()), lifted.end());
    spread(graph, lifted, keys);
    std::ranges::transform(keys, distances.begin(), [](std::int32_t key) { return -key; });
    return true;
}

/// Lifts in rounds, and keeps what parts most.
void part_slits(const SurfaceGraph& graph,
                int rounds,
                std::vector<Slit>& slits,
                std::vector<std::int32_t>& distances) {
    choose_sides(slits, distances);
    std::vector<std::int32_t> best = distances;
    std::ptrdiff_t most = count_parted(slits, distances);
    for (int round = 0; round < rounds && lift(graph, slits, distances); ++round) {
        const std::ptrdiff_t parted = count_parted(slits, distances);
        if (parted <= most) continue;
        most = parted;
        best = distances;
    }
    distances = std::move(best);
}

}  // namespace

SurfaceGraph::SurfaceGraph(const SmoothMesh& mesh, const StepCosts& costs)
    : mesh_(mesh), corners_of_(mesh.fan_count, [&](auto take) {
          for (std::uint32_t corner = 0; corner < mesh.fan_of.size(); ++corner)
              take(mesh.fan_of[corner], corner);
      }) {
    find_slit_ends();
    set_costs(costs);
}

/// Fans that lie on both sides of a crease.
void SurfaceGraph::find_slit_ends() {
    is_slit_end_.assign(mesh_.fan_count, 0);
    for (const FacePair& pair : mesh_.borders) {
        const scene::Edge& edge = mesh_.topology.edges[pair.edge];
        for (const std::uint32_t vertex : {edge.a, edge.b}) {
            const std::uint32_t fan = mesh_.fan_of[mesh_.corner_at(pair.face0, vertex)];
            if (fan == mesh_.fan_of[mesh_.corner_at(pair.face1, vertex)]) is_slit_end_[fan] = 1;
        }
    }
}

void SurfaceGraph::steepen(const std::vector<std::uint32_t>& fans) {
    std::vector<std::uint8_t> is_met(mesh_.fan_count, 0), is_steep(face_count(), 0);
    for (const std::uint32_t fan : fans)
        is_met[fan] = 1;
    for (int ring = 0; ring < 2; ++ring) {
        for (std::uint32_t corner = 0; corner < mesh_.fan_of.size(); ++corner)
            if (is_met[mesh_.fan_of[corner]] != 0) is_steep[corner / 3] = 1;
        for (std::uint32_t corner = 0; corner < mesh_.fan_of.size(); ++corner)
            if (is_steep[corner / 3] != 0) is_met[mesh_.fan_of[corner]] = 1;
    }
    for (std::uint32_t corner = 0; corner < mesh_.fan_of.size(); ++corner) {
        if (is_steep[corner / 3] == 0) continue;
        half_costs_[corner] = kStep / 2;
        const std::uint32_t g = mesh_.across[corner];
        if (g != SmoothMesh::kNone && is_steep[g] != 0) edge_costs_[corner] = kStep;
    }
}

void SurfaceGraph::set_costs(const StepCosts& costs) {
    const scene::Topology& topology = mesh_.topology;
    const std::vector<glm::dvec3> normals = patch_normals(mesh_);
    const std::vector<double> spreads = fan_spreads(mesh_, normals);
    list_touching(costs, normals);
    // Angles as distances between unit vectors, which every machine computes alike.
    const double turn = 2 * std::sin(costs.turn_rad / 2);
    const double half_turn = 2 * std::sin(costs.turn_rad / 4);  // from the mean of a fan
    half_costs_.resize(mesh_.fan_of.size());
    edge_costs_.assign(mesh_.fan_of.size(), kStep);
    for (std::uint32_t f = 0; f < face_count(); ++f) {
        const Extent extent = extent_of(topology, topology.faces[f]);
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t corner = 3 * f + i;
            double half = 0.5 * std::min(spreads[mesh_.fan_of[corner]] / half_turn, 1.0);
            if (!costs.length_world.empty()) {
                const glm::dvec3 p = topology.p_world[topology.faces[f].vertices[i]];
                half = std::min(half, glm::length(p - extent.center) / costs.length_world[f]);
            }
            half_costs_[corner] = whole_cost(half);
            const std::uint32_t g = mesh_.across[corner];
            if (g == SmoothMesh::kNone || g < f) continue;
            double over = glm::length(normals[f] - normals[g]) / turn;
            if (!costs.length_world.empty()) {
                // A straight way crosses an edge about twice for each width of a triangle.
                const Extent beyond = extent_of(topology, topology.faces[g]);
                over = std::min(
                    over,
                    (extent.width / costs.length_world[f] + beyond.width / costs.length_world[g]) /
                        4);
            }
            edge_costs_[corner] = whole_cost(over);
            const std::uint32_t side =
                scene::side_at(topology.faces[g], topology.faces[f].edges[i]);
            edge_costs_[3 * g + side] = edge_costs_[corner];
        }
    }
}

void SurfaceGraph::list_touching(const StepCosts& costs, const std::vector<glm::dvec3>& normals) {
    if (mesh_.touching.empty()) return;
    const double turn = 2 * std::sin(costs.turn_rad / 2);
    touching_ = core::KeyedLists<Touching>(face_count(), [&](auto take) {
        for (const auto& [f, g, edge] : mesh_.touching) {
            // Normals know of no such edges: either side may be the front.
            const double bend = std::min(glm::length(normals[f] - normals[g]),
                                         glm::length(normals[f] + normals[g]));
            const std::int32_t cost = whole_cost(bend / turn);
            take(f, Touching{g, cost});
            take(g, Touching{f, cost});
        }
    });
}

void spread(const SurfaceGraph& graph,
            std::span<const std::uint32_t> sources,
            std::vector<std::int32_t>& keys) {
    // No way costs more than a step, so the keys of what is due span no more than that, once the
    // sources join in the order of theirs.
    constexpr std::int32_t kRing = 2 * kStep;
    static_assert((kRing & (kRing - 1)) == 0);
    std::array<std::vector<std::uint32_t>, kRing> due;
    std::vector<std::uint32_t> waiting(sources.begin(), sources.end());
    std::sort(waiting.begin(), waiting.end(), [&](std::uint32_t a, std::uint32_t b) {
        return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
    });
    std::size_t next = 0;
    std::size_t count = 0;
    const auto place = [](std::int32_t key) {
        return static_cast<std::size_t>(static_cast<std::uint32_t>(key) & (kRing - 1));
    };
    for (std::int32_t key = 0; count > 0 || next < waiting.size(); ++key) {
        if (count == 0) key = keys[waiting[next]];
        for (; next < waiting.size() && keys[waiting[next]] <= key; ++next) {
            // Lowered meanwhile, it has spread already.
            if (keys[waiting[next]] < key) continue;
            due[place(key)].push_back(waiting[next]);
            ++count;
        }
        std::vector<std::uint32_t>& now = due[place(key)];
        for (std::size_t i = 0; i < now.size(); ++i) {  // ways that cost nothing add to it
            const std::uint32_t node = now[i];
            if (keys[node] != key) continue;
            graph.for_each_way(node, [&](std::uint32_t to, std::int32_t cost) {
                if (keys[to] <= key + cost) return;
                keys[to] = key + cost;
                due[place(key + cost)].push_back(to);
                ++count;
            });
        }
        count -= now.size();
        now.clear();
    }
}

void steepen_short_slits(const SmoothMesh& mesh, SurfaceGraph& graph) {
    std::vector<std::uint32_t> ends;
    NearTest is_near(graph);
    for (const FacePair& pair : inner_creases(mesh)) {
        if (!is_near(pair.face0, pair.face1, 2 * kStep)) continue;
        const scene::Edge& edge = mesh.topology.edges[pair.edge];
        for (const std::uint32_t vertex : {edge.a, edge.b}) {
            const std::uint32_t fan = mesh.fan_of[mesh.corner_at(pair.face0, vertex)];
            if (graph.is_slit_end(fan)) ends.push_back(fan);
        }
    }
    graph.steepen(ends);
}

std::vector<std::int32_t> surface_distance(const SmoothMesh& mesh,
                                           const SurfaceGraph& graph,
                                           int rounds,
                                           SlitCount* slits) {
    std::vector<std::uint32_t> ends(mesh.patch_count, SmoothMesh::kNone);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        ends[mesh.patch_of[f]] = std::min(ends[mesh.patch_of[f]], f);
    std::vector<std::int32_t> distances =
        distances_from(graph, farthest_faces(mesh, distances_from(graph, ends)));
    std::vector<Slit> inner = find_slits(mesh, graph);
    part_slits(graph, rounds, inner, distances);
    if (slits) {
        slits->edges = inner.size();
        slits->parted = static_cast<std::size_t>(count_parted(inner, distances));
    }
    distances.resize(mesh.face_count());
    return distances;
}

}  // namespace ink::methods
