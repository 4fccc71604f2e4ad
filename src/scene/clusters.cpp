#include "scene/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "scene/box.h"
#include "scene/face_graph.h"

namespace ink::scene {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

/// What the greedy choice needs to know of a face.
struct FaceShape {
    glm::dvec3 center_world{0};
    glm::dvec3 n_world{0};
};

/// Grows one cluster after the other over the edges of the faces.
///
/// Greedy, as meshoptimizer's clusterizer is (A. Kapoulkine): of the faces at the border the one
/// that costs the fewest new vertices; of those one that would be left alone otherwise, near the
/// middle, whose normal agrees.
class Grower {
  public:
    Grower(const Surface& surface, const FaceGraph& graph, Clusters& clusters)
        : surface_(surface),
          graph_(graph),
          clusters_(clusters),
          is_done_(surface.triangles.size(), false),
          is_listed_(surface.triangles.size(), false),
          proposed_to_(surface.triangles.size(), kNone),
          used_by_(surface.p_world.size(), kNone),
          local_(surface.p_world.size(), kUnlisted) {
        shapes_.reserve(surface.triangles.size());
        for (const auto& [a, b, c] : surface.triangles) {
            const glm::dvec3 p = surface.p_world[a], q = surface.p_world[b], r = surface.p_world[c];
            const glm::dvec3 n = glm::cross(q - p, r - p);
            shapes_.push_back({(p + q + r) / 3.0, unit_or_zero(n)});
        }
    }

    /// Solid by solid, so that the clusters of one are in a row.
    void grow_all() {
        for (std::uint32_t t = 0; t < is_done_.size(); ++t) {
            if (graph_.solid_of[t] == FaceGraph::kNoSolid) {
                clusters_.left_out.push_back(t);
                continue;
            }
            for (std::uint32_t seed = is_done_[t] ? kNone : t; seed != kNone; seed = next_seed()) {
                grow(seed);
                write(seed);
            }
        }
    }

  private:
    static constexpr std::uint8_t kUnlisted = 0xff;
    static_assert(kMaxClusterVertices < kUnlisted);

    struct Choice {
        std::size_t candidate = 0;
        std::uint32_t new_vertices = 4;
        double score = 0;
    };

    template <class Counts>
    [[nodiscard]] std::uint32_t count_neighbours(std::uint32_t t, Counts counts) const {
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t next = graph_.across[3 * t + i];
            count += next != t && counts(next);
        }
        return count;
    }

    void grow(std::uint32_t seed) {
        number_ = static_cast<std::uint32_t>(clusters_.clusters.size());
        vertex_count_ = triangle_count_ = 0;
        center_sum_ = n_sum_ = glm::dvec3(0);
        candidates_.clear();
        propose(seed);
        for (Choice best = choose(); best.new_vertices < 4; best = choose()) {
            const std::uint32_t t = candidates_[best.candidate];
            candidates_[best.candidate] = candidates_.back();
            candidates_.pop_back();
            take(t);
        }
    }

    void propose(std::uint32_t t) {
        if (is_done_[t] || proposed_to_[t] == number_) return;
        proposed_to_[t] = number_;
        candidates_.push_back(t);
    }

    /// The best candidate that still fits; `new_vertices` 4 if none does.
    [[nodiscard]] Choice choose() const {
        Choice best;
        if (triangle_count_ == kMaxClusterTriangles) return best;
        const glm::dvec3 center = center_sum_ / std::max(1.0, double(triangle_count_));
        const glm::dvec3 axis = unit_or_zero(n_sum_);
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            const std::uint32_t t = candidates_[i];
            std::uint32_t cost = 0;
            for (const std::uint32_t corner : surface_.triangles[t])
                cost += used_by_[corner] != number_;
            if (cost > best.new_vertices || vertex_count_ + cost > kMaxClusterVertices) continue;
            const double score = unfitness(t, center, axis);
            if (cost < best.new_vertices || score < best.score) best = {i, cost, score};
        }
        return best;
    }

    /// Tuned by hand on bunny for full clusters that turn away as one: 85 triangles and 37 % of
    /// them seen from outside. More weight on the normals gives narrower cones and longer clusters.
    [[nodiscard]] double unfitness(std::uint32_t t,
                                   const glm::dvec3& center,
                                   const glm::dvec3& axis) const {
        static constexpr double kLeftAlone[4] = {0, 0.1, 1, 1};  // by live neighbours
        const glm::dvec3 arm = shapes_[t].center_world - center;
        const double turn = 1.1 - glm::dot(shapes_[t].n_world, axis);
        const auto is_live = [&](std::uint32_t next) { return !is_done_[next]; };
        return glm::dot(arm, arm) * turn * turn * turn * kLeftAlone[count_neighbours(t, is_live)];
    }

    void take(std::uint32_t t) {
        for (const std::uint32_t corner : surface_.triangles[t]) {
            if (used_by_[corner] == number_) continue;
            used_by_[corner] = number_;
            local_[corner] = kUnlisted;
            ++vertex_count_;
        }
        ++triangle_count_;
        is_done_[t] = true;
        center_sum_ += shapes_[t].center_world;
        n_sum_ += shapes_[t].n_world;
        for (std::size_t i = 0; i < 3; ++i)
            propose(graph_.across[3 * t + i]);
    }

    /// Appends the cluster that grew from `seed`, its triangles along a walk over their edges that
    /// leaves no dead ends behind if it can, its vertices as the walk meets them.
    void write(std::uint32_t seed) {
        Cluster cluster;
        cluster.first_vertex = static_cast<std::uint32_t>(clusters_.vertices.size());
        cluster.first_triangle = static_cast<std::uint32_t>(clusters_.triangle_ids.size());
        cluster.vertex_count = static_cast<std::uint16_t>(vertex_count_);
        cluster.triangle_count = static_cast<std::uint16_t>(triangle_count_);
        cluster.solid = graph_.solid_of[seed];
        clusters_.clusters.push_back(cluster);
        const auto is_left = [&](std::uint32_t t) {
            return is_done_[t] && proposed_to_[t] == number_ && !is_listed_[t];
        };
        walk_.assign(1, seed);
        list(seed);
        while (!walk_.empty()) {
            std::uint32_t best = kNone, best_left = 4;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t next = graph_.across[3 * walk_.back() + i];
                if (!is_left(next)) continue;
                const std::uint32_t left = count_neighbours(next, is_left);
                if (left < best_left) {
                    best = next;
                    best_left = left;
                }
            }
            if (best == kNone) {
                walk_.pop_back();
                continue;
            }
            list(best);
            walk_.push_back(best);
        }
    }

    void list(std::uint32_t t) {
        is_listed_[t] = true;
        std::array<std::uint8_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t corner = surface_.triangles[t][i];
            if (local_[corner] == kUnlisted) {
                const std::size_t first = clusters_.clusters.back().first_vertex;
                local_[corner] = static_cast<std::uint8_t>(clusters_.vertices.size() - first);
                clusters_.vertices.push_back(corner);
                clusters_.places.push_back(graph_.corner_at[graph_.places[3 * t + i]]);
            }
            corners[i] = local_[corner];
        }
        clusters_.triangles.push_back(corners);
        clusters_.triangle_ids.push_back(t);
    }

    /// Among the oldest faces at the border of what is done the one nearest to the last cluster:
    /// the oldest, so that the border stays short and no islands remain; the nearest, so that
    /// neighbours follow each other. kNone if the solid is done.
    std::uint32_t next_seed() {
        constexpr std::size_t kOldest =
            32;  // tuned on bunny: 8 jump farther, 200 leave more islands
        border_.insert(border_.end(), candidates_.begin(), candidates_.end());
        std::erase_if(oldest_, [&](std::uint32_t t) { return is_done_[t]; });
        for (; next_oldest_ < border_.size() && oldest_.size() < kOldest; ++next_oldest_) {
            const std::uint32_t t = border_[next_oldest_];
            if (!is_done_[t]) oldest_.push_back(t);
        }
        const glm::dvec3 center = center_sum_ / double(triangle_count_);
        std::uint32_t best = kNone;
        double best_square = 0;
        for (const std::uint32_t t : oldest_) {
            const glm::dvec3 arm = shapes_[t].center_world - center;
            const double square = glm::dot(arm, arm);
            if (best != kNone && square >= best_square) continue;
            best = t;
            best_square = square;
        }
        return best;
    }

    const Surface& surface_;
    const FaceGraph& graph_;
    Clusters& clusters_;
    std::vector<FaceShape> shapes_;
    std::vector<bool> is_done_;               ///< in some cluster
    std::vector<bool> is_listed_;             ///< and written there
    std::vector<std::uint32_t> proposed_to_;  ///< the last cluster that could have had each face
    std::vector<std::uint32_t> used_by_;      ///< the last cluster that has each corner
    std::vector<std::uint8_t> local_;         ///< its number there
    std::vector<std::uint32_t> candidates_;   ///< at the border of the cluster that grows
    std::vector<std::uint32_t> border_;       ///< what clusters left there, the oldest first
    std::size_t next_oldest_ = 0;             ///< in border_: all before are done or in oldest_
    std::vector<std::uint32_t> oldest_;
    std::vector<std::uint32_t> walk_;
    std::uint32_t number_ = 0;  ///< of the cluster that grows; so the rest
    std::size_t vertex_count_ = 0;
    std::size_t triangle_count_ = 0;
    glm::dvec3 center_sum_{0};
    glm::dvec3 n_sum_{0};
};

}  // namespace

Clusters make_clusters(const Surface& surface) {
    Clusters clusters;
    const FaceGraph graph = make_face_graph(surface);
    clusters.solids.resize(graph.is_closed.size());
    for (std::size_t s = 0; s < graph.is_closed.size(); ++s)
        clusters.solids[s].is_closed = graph.is_closed[s];
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const std::uint32_t solid = graph.solid_of[t];
        if (solid != FaceGraph::kNoSolid) clusters.solids[solid].object = surface.object[t];
    }
    find_holes(graph, clusters);
    Grower(surface, graph, clusters).grow_all();
    refresh(surface, clusters);
    return clusters;
}

}  // namespace ink::scene
