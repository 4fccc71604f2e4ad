#include "buffers/vertex_weld.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/numbering.h"
#include "scene/predicates.h"

namespace ink::buffers {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

/// The places found so far, listed by the cube they lie in.
class Places {
  public:
    Places(std::span<const glm::dvec3> points, double distance)
        : points_(points), distance_(distance), cells_(points.size()) {}

    /// The first place within reach of a point, or kNone.
    [[nodiscard]] std::uint32_t find(const glm::dvec3& p) const {
        const glm::dvec3 low = cell_of(p - distance_), high = cell_of(p + distance_);
        std::uint32_t first = kNone;
        for (int corner = 0; corner < 8; ++corner) {
            glm::dvec3 cell = low;
            bool is_new = true;
            for (int axis = 0; axis < 3; ++axis) {
                if ((corner >> axis & 1) == 0) continue;
                is_new = is_new && high[axis] != low[axis];
                cell[axis] = high[axis];
            }
            if (is_new) first = std::min(first, first_in(cell, p));
        }
        return first;
    }

    void add(std::uint32_t vertex) {
        const auto [cell, is_new] = cells_.insert(cell_of(points_[vertex]));
        if (is_new) last_in_.push_back(kNone);
        next_.push_back(last_in_[cell]);
        last_in_[cell] = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(vertex);
    }

    [[nodiscard]] std::vector<std::uint32_t> take() { return std::move(vertices_); }

  private:
    /// The cube's corner in units of its side; the point itself where nothing is tolerated. A
    /// double, so that no coordinate is too large for it. -0 becomes 0.
    [[nodiscard]] glm::dvec3 cell_of(const glm::dvec3& p) const {
        return distance_ == 0 ? p + 0.0 : glm::floor(p / (kSide * distance_)) + 0.0;
    }
    [[nodiscard]] std::uint32_t first_in(const glm::dvec3& cell, const glm::dvec3& p) const {
        std::uint32_t first = kNone;
        const auto number = cells_.find(cell);
        if (!number) return first;
        for (std::uint32_t i = last_in_[*number]; i != kNone; i = next_[i]) {
            const glm::dvec3 d = points_[vertices_[i]] - p;
            if (glm::dot(d, d) <= distance_ * distance_) first = std::min(first, i);
        }
        return first;
    }

    /// A cube's side over the distance: more crowds the cubes, less looks at more than one of them.
    static constexpr double kSide = 4;

    std::span<const glm::dvec3> points_;
    double distance_;
    core::Numbering<glm::dvec3> cells_;
    std::vector<std::uint32_t> last_in_;   ///< per cube its last place
    std::vector<std::uint32_t> next_;      ///< per place the one before in its cube
    std::vector<std::uint32_t> vertices_;  ///< per place its first vertex
};

}  // namespace

VertexWeld weld_vertices(std::span<const glm::dvec3> points, double distance) {
    assert(distance >= 0);
    VertexWeld weld;
    weld.place_of.resize(points.size());
    Places places(points, distance);
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < points.size(); ++v) {
        std::uint32_t place = places.find(points[v]);
        if (place == kNone) {
            place = count++;
            places.add(v);
        }
        weld.place_of[v] = place;
    }
    weld.first_of = places.take();
    return weld;
}

WeldedFaces weld_faces(const VertexWeld& weld,
                       std::span<const glm::dvec3> points,
                       std::span<const scene::Triangle> triangles,
                       DoubleFaces double_faces) {
    WeldedFaces welded;
    core::Numbering<scene::Triangle> seen(double_faces == DoubleFaces::drop ? triangles.size() : 0);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        scene::Triangle face{};
        std::array<glm::dvec3, 3> p{};
        for (std::size_t i = 0; i < 3; ++i) {
            face[i] = weld.place_of[triangles[t][i]];
            p[i] = points[weld.first_of[face[i]]];
        }
        if (scene::is_collinear(p[0], p[1], p[2])) {  // as are two corners of one place
            ++welded.degenerate;
            continue;
        }
        if (double_faces == DoubleFaces::drop) {
            scene::Triangle key = face;
            std::ranges::sort(key);
            if (!seen.insert(key).second) {
                ++welded.duplicate;
                continue;
            }
        }
        welded.faces.push_back(face);
        welded.triangle_of.push_back(t);
    }
    return welded;
}

}  // namespace ink::buffers
