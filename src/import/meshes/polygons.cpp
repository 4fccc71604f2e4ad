#include "import/meshes/polygons.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <utility>

namespace ink::import {
namespace {

using Corners = std::span<const std::uint32_t>;

/// Twice the area of the triangle a, b, c; above 0 if it turns to the left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The face's corners as seen from its front, by the two axes along which it is largest.
std::vector<glm::dvec2> flattened(Corners face, const std::vector<glm::dvec3>& positions) {
    const glm::dvec3 first = positions[face[0]];
    glm::dvec3 normal{0};
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        normal += glm::cross(positions[face[i]] - first, positions[face[i + 1]] - first);
    const glm::dvec3 size = glm::abs(normal);
    const int up = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const int right = (up + 1) % 3;
    const int forward = (up + 2) % 3;
    std::vector<glm::dvec2> flat;
    for (const std::uint32_t v : face) {
        const glm::dvec3 p = positions[v] - first;
        flat.emplace_back(normal[up] < 0 ? -p[right] : p[right], p[forward]);
    }
    return flat;
}

void append_fan(Corners face, std::size_t from, std::vector<scene::Triangle>& triangles) {
    const std::size_t n = face.size();
    for (std::size_t i = 1; i + 1 < n; ++i)
        triangles.push_back({face[from], face[(from + i) % n], face[(from + i + 1) % n]});
}

/// The corners of a face that is being cut up.
class Remainder {
  public:
    explicit Remainder(std::vector<glm::dvec2> flat) : flat_(std::move(flat)) {
        for (std::size_t i = 0; i < flat_.size(); ++i)
            left_.push_back(i);
    }

    [[nodiscard]] std::size_t size() const { return left_.size(); }
    [[nodiscard]] std::size_t at(std::size_t i) const { return left_[i % size()]; }
    void cut(std::size_t i) {
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i % size()));
    }

    /// Whether the corner points inwards, or nowhere: no triangle of an area has it for its tip.
    [[nodiscard]] bool is_dent(std::size_t i) const {
        return !(turn(p(i + size() - 1), p(i), p(i + 1)) > 0);
    }
    /// Whether the corner sticks out and its triangle holds no other.
    [[nodiscard]] bool is_ear(std::size_t i) const {
        const glm::dvec2 a = p(i + size() - 1), b = p(i), c = p(i + 1);
        if (!(turn(a, b, c) > 0)) return false;
        for (std::size_t k = 2; k + 1 < size(); ++k) {
            const glm::dvec2 q = p(i + k);
            const bool is_inside = turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0;
            // A hole is joined to its rim by corners that stand on others.
            if (is_inside && q != a && q != b && q != c) return false;
        }
        return true;
    }

  private:
    [[nodiscard]] const glm::dvec2& p(std::size_t i) const { return flat_[at(i)]; }

    std::vector<glm::dvec2> flat_;
    std::vector<std::size_t> left_;
};

void append_ears(Corners face, Remainder remainder, std::vector<scene::Triangle>& triangles) {
    std::size_t i = 0;
    while (remainder.size() > 3) {
        std::size_t tried = 0;
        while (tried < remainder.size() && !remainder.is_ear(i)) {
            i = (i + 1) % remainder.size();
            ++tried;
        }
        const std::size_t before = remainder.at(i + remainder.size() - 1);
        triangles.push_back({face[before], face[remainder.at(i)], face[remainder.at(i + 1)]});
        remainder.cut(i);
        i %= remainder.size();
    }
    triangles.push_back({face[remainder.at(0)], face[remainder.at(1)], face[remainder.at(2)]});
}

void append_triangles(Corners face,
                      const std::vector<glm::dvec3>& positions,
                      std::vector<scene::Triangle>& triangles) {
    if (face.size() < 3) return;
    if (face.size() == 3) return append_fan(face, 0, triangles);
    Remainder remainder(flattened(face, positions));
    std::size_t dents = 0;
    std::size_t last_dent = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
        if (!remainder.is_dent(i)) continue;
        ++dents;
        last_dent = i;
    }
    if (dents == 0 || face.size() == 4) return append_fan(face, last_dent, triangles);
    append_ears(face, std::move(remainder), triangles);
}

}  // namespace

std::vector<scene::Triangle> triangles_of(const Polygons& polygons,
                                          const std::vector<glm::dvec3>& positions) {
    std::vector<scene::Triangle> triangles;
    triangles.reserve(polygons.corners.size() / 3);
    std::size_t first = 0;
    for (const std::size_t end : polygons.ends) {
        append_triangles(
            Corners(polygons.corners).subspan(first, end - first), positions, triangles);
        first = end;
    }
    return triangles;
}

std::size_t count_without_area(const Polygons& polygons) {
    std::size_t count = 0;
    std::size_t first = 0;
    for (const std::size_t end : polygons.ends) {
        count += end - first < 3 ? 1 : 0;
        first = end;
    }
    return count;
}

ImportReply reply_of_mesh(ImportedMesh mesh, const Polygons& faces) {
    ImportReply reply;
    mesh.triangles = triangles_of(faces, mesh.positions);
    reply.instances.push_back({.mesh = 0, .name = mesh.name});
    reply.meshes.push_back(std::move(mesh));
    const std::size_t poor = count_without_area(faces);
    if (poor > 0)
        reply.notes.push_back(counted(poor, "face") + " of less than 3 corners: left out");
    return reply;
}

std::string drawn_opaque(std::size_t materials) {
    return counted(materials, "transparent material") + (materials == 1 ? " is" : " are") +
           " drawn opaque";
}

std::string counted(std::size_t count, std::string_view what) {
    return std::to_string(count) + ' ' + std::string(what) + (count == 1 ? "" : "s");
}

}  // namespace ink::import
