#include "buffers/codes/surface_distance.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "core/disjoint_sets.h"

namespace ink::buffers {
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

/// A crease inside a patch, as its two sides.
struct Slit {
    std::uint32_t low = 0;  ///< the face whose chain has the lower number
    std::uint32_t high = 0;
    std::uint64_t chains = 0;  ///< those two numbers
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

/// The creases inside patches that can be parted, those with the same chains of faces beside them
/// together. A chain is what is joined along creases over fans, so that a long crease is lifted on
/// one side alone.
std::vector<Slit> find_slits(const SmoothMesh& mesh, const SurfaceGraph& graph) {
    std::vector<FacePair> inner;
    for (const FacePair& pair : mesh.borders) {
        if (mesh.patch_of[pair.face0] == mesh.patch_of[pair.face1]) inner.push_back(pair);
    }
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
    std::stable_sort(slits.begin(), slits.end(), [](const Slit& a, const Slit& b) {
        return a.chains < b.chains;
    });
    return slits;
}

bool is_parted(const Slit& slit, const std::vector<std::int32_t>& distances) {
    const std::int32_t low = distances[slit.low] / kStep, high = distances[slit.high] / kStep;
    return low - high >= 2 || high - low >= 2;
}

/// Lifts one side of what is not parted yet. `keys` are distances below 0: lifting lowers them.
/// Returns whether there was anything to do.
bool lift(const SurfaceGraph& graph,
          const std::vector<Slit>& slits,
          std::vector<std::int32_t>& distances) {
    std::vector<std::uint32_t> lifted;
    std::vector<std::int32_t> keys(distances.size());
    std::transform(
        distances.begin(), distances.end(), keys.begin(), [](std::int32_t d) { return -d; });
    for (auto run = slits.begin(); run != slits.end();) {
        const auto end =
            std::find_if(run, slits.end(), [&](const Slit& s) { return s.chains != run->chains; });
        std::int64_t lead = 0;  // of the high chain over the low one, all along
        for (auto slit = run; slit != end; ++slit)
            lead += distances[slit->high] - distances[slit->low];
        const bool is_own_chain = run->chains >> 32 == (run->chains & 0xffffffffU);
        for (; run != end; ++run) {
            if (is_parted(*run, distances)) continue;
            const bool lifts_high =
                is_own_chain ? distances[run->high] >= distances[run->low] : lead >= 0;
            const std::uint32_t up = lifts_high ? run->high : run->low;
            const std::uint32_t down = lifts_high ? run->low : run->high;
            lifted.push_back(up);
            keys[up] = std::min(keys[up], -(distances[down] + 2 * kStep));
        }
    }
    if (lifted.empty()) return false;
    std::sort(lifted.begin(), lifted.end());
    lifted.erase(std::unique(lifted.begin(), lifted.end()), lifted.end());
    spread(graph, lifted, keys);
    std::transform(
        keys.begin(), keys.end(), distances.begin(), [](std::int32_t key) { return -key; });
    return true;
}

}  // namespace

std::vector<std::int32_t> surface_distance(
    const SmoothMesh& mesh, const SurfaceGraph& graph, End end, int rounds, SlitCount* slits) {
    std::vector<std::uint32_t> ends(mesh.patch_count, SmoothMesh::kNone);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        ends[mesh.patch_of[f]] = std::min(ends[mesh.patch_of[f]], f);
    ends = farthest_faces(mesh, distances_from(graph, ends));
    std::vector<std::int32_t> distances = distances_from(graph, ends);
    if (end == End::side) {
        const auto opposite = distances_from(graph, farthest_faces(mesh, distances));
        for (std::size_t i = 0; i < distances.size(); ++i)
            distances[i] = std::min(distances[i], opposite[i]);
        distances = distances_from(graph, farthest_faces(mesh, distances));
    }
    const std::vector<Slit> inner = find_slits(mesh, graph);
    for (int round = 0; round < rounds && lift(graph, inner, distances); ++round) {
    }
    if (slits) {
        slits->edges = inner.size();
        slits->parted = static_cast<std::size_t>(std::count_if(
            inner.begin(), inner.end(), [&](const Slit& s) { return is_parted(s, distances); }));
    }
    distances.resize(mesh.face_count());
    return distances;
}

}  // namespace ink::buffers
