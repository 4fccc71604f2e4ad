#include "methods/surface_codes/touching_boundaries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

namespace ink::methods {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// Vertices by the cells of a grid.
class Cells {
  public:
    Cells(double size, std::span<const glm::dvec3> p_world, std::span<const std::uint32_t> vertices)
        : size_(size) {
        for (const std::uint32_t vertex : vertices)
            filled_.emplace_back(cell(p_world[vertex]), vertex);
        std::sort(filled_.begin(), filled_.end());
    }

    [[nodiscard]] Cell cell(const glm::dvec3& p) const {
        const glm::dvec3 at = glm::floor(p / size_);
        return {static_cast<std::int64_t>(at.x),
                static_cast<std::int64_t>(at.y),
                static_cast<std::int64_t>(at.z)};
    }

    /// Appends the vertices of all cells of a box.
    void add_inside(const glm::dvec3& low,
                    const glm::dvec3& high,
                    std::vector<std::uint32_t>& found) const {
        const Cell first = cell(low), last = cell(high);
        for (std::int64_t x = first[0]; x <= last[0]; ++x) {
            for (std::int64_t y = first[1]; y <= last[1]; ++y) {
                // Cells of one row stand together.
                auto at = std::lower_bound(
                    filled_.begin(), filled_.end(), Filled{Cell{x, y, first[2]}, 0});
                const Filled end{Cell{x, y, last[2]}, std::numeric_limits<std::uint32_t>::max()};
                for (; at != filled_.end() && *at <= end; ++at)
                    found.push_back(at->second);
            }
        }
    }

  private:
    using Filled = std::pair<Cell, std::uint32_t>;

    double size_;
    std::vector<Filled> filled_;
};

/// The boundary edges of one object.
class Boundaries {
  public:
    Boundaries(const scene::Topology& topology,
               std::span<const std::uint32_t> edges,
               const buffers::PatchOptions& options)
        : topology_(topology), options_(options), edges_(edges.begin(), edges.end()) {
        glm::dvec3 low{std::numeric_limits<double>::infinity()}, high = -low;
        double length = 0;
        for (const std::uint32_t e : edges_) {
            const scene::Edge& edge = topology.edges[e];
            for (const std::uint32_t vertex : {edge.a, edge.b}) {
                low = glm::min(low, p(vertex));
                high = glm::max(high, p(vertex));
                rounding_ = std::max(rounding_, topology.rounding_world[vertex]);
                edges_at_.emplace_back(vertex, e);
            }
            length += glm::length(p(edge.a) - p(edge.b));
        }
        near_ = std::max(options.weld_epsilon * glm::length(high - low), 4 * rounding_);
        mean_length_ = length / static_cast<double>(edges_.size());
        std::sort(edges_at_.begin(), edges_at_.end());
    }

    void add_touching(std::vector<FacePair>& pairs) const {
        if (!(mean_length_ > near_)) return;
        std::vector<std::uint32_t> vertices;
        for (const auto& [vertex, edge] : edges_at_)
            if (vertices.empty() || vertices.back() != vertex) vertices.push_back(vertex);
        const Cells cells(mean_length_, topology_.p_world, vertices);
        std::vector<std::uint32_t> found;
        for (const std::uint32_t e : edges_) {
            const glm::dvec3 a = p(topology_.edges[e].a), b = p(topology_.edges[e].b);
            // Piece by piece: the box round all of a slanted edge has many cells.
            const int count = 1 + static_cast<int>(glm::length(b - a) / mean_length_);
            found.clear();
            for (int i = 0; i < count; ++i) {
                const glm::dvec3 from = glm::mix(a, b, static_cast<double>(i) / count);
                const glm::dvec3 to = glm::mix(a, b, static_cast<double>(i + 1) / count);
                cells.add_inside(glm::min(from, to) - near_, glm::max(from, to) + near_, found);
            }
            std::sort(found.begin(), found.end());
            found.erase(std::unique(found.begin(), found.end()), found.end());
            for (const std::uint32_t vertex : found)
                add_at(e, vertex, pairs);
        }
    }

  private:
    [[nodiscard]] const glm::dvec3& p(std::uint32_t vertex) const {
        return topology_.p_world[vertex];
    }
    [[nodiscard]] std::uint32_t face_of(std::uint32_t edge) const {
        return topology_.faces_of(topology_.edges[edge])[0];
    }

    /// The faces whose boundaries run from a vertex along an edge on whose inside it lies.
    void add_at(std::uint32_t e, std::uint32_t vertex, std::vector<FacePair>& pairs) const {
        const glm::dvec3 a = p(topology_.edges[e].a);
        const glm::dvec3 whole = p(topology_.edges[e].b) - a;
        const double length = glm::length(whole);
        if (!(length > 2 * near_)) return;
        const glm::dvec3 along = whole / length;
        const double at = glm::dot(p(vertex) - a, along);
        if (at <= near_ || at >= length - near_) return;
        if (glm::length(p(vertex) - a - at * along) > near_) return;
        for (auto run = std::lower_bound(
                 edges_at_.begin(), edges_at_.end(), std::make_pair(vertex, std::uint32_t{0}));
             run != edges_at_.end() && run->first == vertex;
             ++run) {
            const scene::Edge& other = topology_.edges[run->second];
            const glm::dvec3 way = p(other.a == vertex ? other.b : other.a) - p(vertex);
            // As far as both go.
            const double ahead = glm::dot(way, along);
            const double most = ahead > 0 ? length - at : at;
            if (std::abs(ahead) <= near_) continue;
            const glm::dvec3 end = p(vertex) + way * std::min(1.0, most / std::abs(ahead)) - a;
            if (glm::length(end - glm::dot(end, along) * along) > near_) continue;
            const std::uint32_t f = face_of(e), g = face_of(run->second);
            if (f != g && goes_on(e, f, run->second, g)) pairs.push_back({f, g, e});
        }
    }

    /// Whether two faces on one line lie on its two sides, and bend by less than a crease.
    [[nodiscard]] bool goes_on(std::uint32_t e,
                               std::uint32_t f,
                               std::uint32_t other,
                               std::uint32_t g) const {
        const glm::dvec3 a = p(topology_.edges[e].a);
        const glm::dvec3 along = glm::normalize(p(topology_.edges[e].b) - a);
        const auto into = [&](std::uint32_t face, std::uint32_t edge) {
            const glm::dvec3 to =
                p(scene::opposite_vertex(topology_.faces[face], topology_.edges[edge])) - a;
            return to - along * glm::dot(to, along);
        };
        const glm::dvec3 one = into(f, e), two = into(g, other);
        const double bend =
            std::atan2(glm::length(glm::cross(one, two)), -glm::dot(one, two));  // 0: flat
        return bend < options_.crease_rad;
    }

    const scene::Topology& topology_;
    const buffers::PatchOptions& options_;
    std::vector<std::uint32_t> edges_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_at_;  ///< vertex, edge; ascending
    double near_ = 0;
    double rounding_ = 0;
    double mean_length_ = 0;
};

}  // namespace

std::vector<FacePair> touching_boundaries(const scene::Topology& topology,
                                          const buffers::PatchOptions& options) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_object;
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
        const scene::Edge& edge = topology.edges[e];
        if (edge.face_count != 1) continue;
        by_object.emplace_back(topology.faces[topology.faces_of(edge)[0]].object, e);
    }
    std::sort(by_object.begin(), by_object.end());
    std::vector<FacePair> pairs;
    std::vector<std::uint32_t> edges;
    for (std::size_t i = 0; i < by_object.size();) {
        const std::uint32_t object = by_object[i].first;
        edges.clear();
        for (; i < by_object.size() && by_object[i].first == object; ++i)
            edges.push_back(by_object[i].second);
        Boundaries(topology, edges, options).add_touching(pairs);
    }
    const auto faces = [](const FacePair& pair) { return std::tie(pair.face0, pair.face1); };
    std::sort(pairs.begin(), pairs.end(), [&](const FacePair& a, const FacePair& b) {
        return faces(a) < faces(b);
    });
    pairs.erase(
        std::unique(pairs.begin(),
                    pairs.end(),
                    [&](const FacePair& a, const FacePair& b) { return faces(a) == faces(b); }),
        pairs.end());
    return pairs;
}

}  // namespace ink::methods
