#include "methods/surface_codes/smooth_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <span>
#include <tuple>

#include "core/disjoint_sets.h"
#include "core/numbering.h"
#include "scene/box.h"
#include "scene/precision/rounding.h"
#include "scene/surface.h"

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
        std::ranges::sort(filled_);
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
                auto at = std::ranges::lower_bound(filled_, Filled{Cell{x, y, first[2]}, 0});
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
        scene::Box box;
        double length = 0;
        for (const std::uint32_t e : edges_) {
            const scene::Edge& edge = topology.edges[e];
            for (const std::uint32_t vertex : {edge.a, edge.b}) {
                box.add(p(vertex));
                rounding_ = std::max(rounding_, topology.rounding_world[vertex]);
                edges_at_.emplace_back(vertex, e);
            }
            length += glm::length(p(edge.a) - p(edge.b));
        }
        near_ = std::max(options.weld_epsilon * box.diagonal(), 4 * rounding_);
        mean_length_ = length / static_cast<double>(edges_.size());
        std::ranges::sort(edges_at_);
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
            std::ranges::sort(found);
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
        for (auto run =
                 std::ranges::lower_bound(edges_at_, std::make_pair(vertex, std::uint32_t{0}));
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

/// Pairs of faces of one object whose boundaries lie on each other without having both ends in
/// common, where the surface goes on flatter than a crease: the T-junctions of a mesh.
///
/// `edge` is that of the first face, on whose inside an end of the second face's edge lies, as near
/// as `options.weld_epsilon` has it (a share of the object's diagonal) and rounding can tell. Each
/// pair once, ascending. O(n log n) for n boundary edges that are alike in length.
std::vector<FacePair> touching_boundaries(const scene::Topology& topology,
                                          const buffers::PatchOptions& options) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> by_object;
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
        const scene::Edge& edge = topology.edges[e];
        if (edge.face_count == 1)
            by_object[topology.faces[topology.faces_of(edge)[0]].object].push_back(e);
    }
    std::vector<FacePair> pairs;
    for (const auto& [object, edges] : by_object)
        Boundaries(topology, edges, options).add_touching(pairs);
    const auto faces = [](const FacePair& pair) { return std::tie(pair.face0, pair.face1); };
    std::ranges::sort(pairs, {}, faces);
    const auto are_same = [&](const FacePair& a, const FacePair& b) {
        return faces(a) == faces(b);
    };
    pairs.erase(std::unique(pairs.begin(), pairs.end(), are_same), pairs.end());
    return pairs;
}

/// Edges of more faces than this part all of them.
constexpr std::size_t kMostPaired = 16;

/// Whether a surface goes on over an edge: from one object to the same, and no crease.
bool is_smooth(const scene::Topology& topology,
               const scene::Edge& edge,
               const FacePair& pair,
               double crease_rad) {
    return topology.faces[pair.face0].object == topology.faces[pair.face1].object &&
           !scene::is_crease(topology, edge, pair.face0, pair.face1, crease_rad);
}

/// Which faces of an edge of more than two go on over it: those that do so with each other alone. A
/// wall goes on behind another that meets it; where three sheets part, none does.
std::vector<FacePair> pairs_of_many(const scene::Topology& topology,
                                    std::uint32_t e,
                                    double crease_rad) {
    const scene::Edge& edge = topology.edges[e];
    const auto faces = topology.faces_of(edge);
    if (faces.size() > kMostPaired) return {};
    std::vector<FacePair> smooth;
    std::vector<int> ways(faces.size(), 0);
    for (std::size_t i = 1; i < faces.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (!is_smooth(topology, edge, {faces[k], faces[i], e}, crease_rad)) continue;
            smooth.push_back({static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(i), e});
            ++ways[k];
            ++ways[i];
        }
    }
    std::erase_if(
        smooth, [&](const FacePair& pair) { return ways[pair.face0] > 1 || ways[pair.face1] > 1; });
    for (FacePair& pair : smooth)
        pair = {faces[pair.face0], faces[pair.face1], e};
    return smooth;
}

/// The number that is there most often, the lowest of those; kNone of none.
std::uint32_t most_frequent(std::vector<std::uint32_t> numbers) {
    std::ranges::sort(numbers);
    std::uint32_t best = SmoothMesh::kNone;
    std::ptrdiff_t most = 0;
    for (auto run = numbers.begin(); run != numbers.end();) {
        const auto end = std::upper_bound(run, numbers.end(), *run);
        if (end - run > most) {
            most = end - run;
            best = *run;
        }
        run = end;
    }
    return best;
}

SmoothMesh cut_into_patches(const scene::PreparedScene& scene,
                            const buffers::PatchOptions& options) {
    SmoothMesh mesh;
    mesh.topology = *scene.topology(options.weld_epsilon);
    const scene::Topology& topology = mesh.topology;
    const auto count = static_cast<std::uint32_t>(topology.faces.size());
    mesh.across.assign(std::size_t{3} * count, SmoothMesh::kNone);
    core::DisjointSets patches(count);
    core::DisjointSets fans(std::size_t{3} * count);
    const auto join = [&](const FacePair& pair) {
        const auto [f, g, e] = pair;
        const scene::Edge& edge = topology.edges[e];
        patches.join(f, g);
        fans.join(mesh.corner_at(f, edge.a), mesh.corner_at(g, edge.a));
        fans.join(mesh.corner_at(f, edge.b), mesh.corner_at(g, edge.b));
        mesh.across[3 * f + scene::side_at(topology.faces[f], e)] = g;
        mesh.across[3 * g + scene::side_at(topology.faces[g], e)] = f;
    };
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
        const scene::Edge& edge = topology.edges[e];
        const auto faces = topology.faces_of(edge);
        if (faces.size() == 2) {
            const FacePair pair{faces[0], faces[1], e};
            if (is_smooth(topology, edge, pair, options.crease_rad)) {
                join(pair);
            } else {
                mesh.borders.push_back(pair);
            }
        } else if (faces.size() > 2) {
            for (const FacePair& pair : pairs_of_many(topology, e, options.crease_rad))
                join(pair);
            for (std::size_t i = 1; i < faces.size(); ++i) {
                for (std::size_t k = i < kMostPaired ? 0 : i - 1; k < i; ++k) {
                    const auto& f = topology.faces[faces[k]];
                    if (mesh.across[3 * faces[k] + scene::side_at(f, e)] != faces[i])
                        mesh.borders.push_back({faces[k], faces[i], e});
                }
            }
        }
    }
    mesh.touching = touching_boundaries(topology, options);
    for (const FacePair& pair : mesh.touching)
        patches.join(pair.face0, pair.face1);
    std::tie(mesh.patch_of, mesh.patch_count) = patches.numbers();
    std::tie(mesh.fan_of, mesh.fan_count) = fans.numbers();
    return mesh;
}

}  // namespace

std::shared_ptr<const SmoothMesh> make_smooth_mesh(const scene::PreparedScene& scene,
                                                   const buffers::PatchOptions& options) {
    const std::string name =
        fmt::format("smooth mesh {} {}", options.crease_rad, options.weld_epsilon);
    return scene.get(name, [&] { return cut_into_patches(scene, options); });
}

namespace {

std::vector<std::uint32_t> find_faces(const scene::PreparedScene& scene,
                                      const scene::Topology& topology) {
    std::vector<std::uint32_t> face_of(scene::triangle_count(scene), SmoothMesh::kNone);
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f)
        face_of[topology.faces[f].triangle] = f;
    if (topology.lost.empty()) return face_of;
    const auto flat = scene.surface();
    const scene::Surface& surface = *flat;
    const auto places = [&](std::uint32_t triangle) {
        std::array<glm::dvec3, 3> p{};
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = surface.p_world[surface.triangles[triangle][i]] + 0.0;  // -0 is 0
        return p;
    };
    // Only places of triangles that became no face: they are few. Which faces have a corner there?
    struct Left {
        std::uint32_t triangle = 0;
        std::array<std::uint32_t, 3> places{};
    };
    core::Numbering<glm::dvec3> numbers(topology.lost.size());
    std::vector<Left> left;
    for (const scene::LostTriangle& lost : topology.lost) {
        const auto [a, b, c] = places(lost.triangle);
        left.push_back(
            {lost.triangle,
             {numbers.insert(a).first, numbers.insert(b).first, numbers.insert(c).first}});
    }
    std::vector<std::vector<std::uint32_t>> faces_at(numbers.keys().size());
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        for (const glm::dvec3& p : places(topology.faces[f].triangle))
            if (const auto number = numbers.find(p)) faces_at[*number].push_back(f);
    }
    // Where welding left no area of many triangles together, those inside follow those round them.
    while (!left.empty()) {
        std::vector<Left> found, still;
        for (const Left& one : left) {
            // The face that shares most corners with it, the first of those that share as many.
            std::vector<std::uint32_t> met;
            for (const std::uint32_t place : one.places)
                met.insert(met.end(), faces_at[place].begin(), faces_at[place].end());
            std::uint32_t& face = face_of[one.triangle];
            face = most_frequent(std::move(met));
            (face == SmoothMesh::kNone ? still : found).push_back(one);
        }
        if (found.empty()) break;
        for (const Left& one : found) {
            for (const std::uint32_t place : one.places)
                faces_at[place].push_back(face_of[one.triangle]);
        }
        left = std::move(still);
    }
    return face_of;
}

}  // namespace

std::shared_ptr<const std::vector<std::uint32_t>> faces_of_triangles(
    const scene::PreparedScene& scene, const SmoothMesh& mesh, double weld_epsilon) {
    return scene.get(fmt::format("faces of triangles {}", weld_epsilon),
                     [&] { return find_faces(scene, mesh.topology); });
}

}  // namespace ink::methods
