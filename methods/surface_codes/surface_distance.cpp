#include "methods/surface_codes/surface_distance.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "core/disjoint_sets.h"

namespace ink::methods {
namespace {

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
