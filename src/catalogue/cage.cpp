#include "catalogue/cage.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

namespace ink::catalogue {
namespace {

glm::dvec3 centre_of(const Cage& cage, const Cage::Face& face) {
    glm::dvec3 sum{0};
    for (const auto corner : face)
        sum += cage.points[corner];
    return sum / static_cast<double>(face.size());
}

/// The normal of a polygon by Newell's sum, of length 1.
glm::dvec3 normal_of(const Cage& cage, const Cage::Face& face) {
    const glm::dvec3 centre = centre_of(cage, face);
    glm::dvec3 sum{0};
    for (std::size_t i = 0; i < face.size(); ++i) {
        const auto& a = cage.points[face[i]];
        const auto& b = cage.points[face[(i + 1) % face.size()]];
        sum += glm::cross(a - centre, b - centre);
    }
    return glm::normalize(sum);
}

/// `v` turned by the smallest turn that takes `from` to `to`, both of length 1 and not opposite.
glm::dvec3 carried(const glm::dvec3& v, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 axis = glm::cross(from, to);
    return v + glm::cross(axis, v) +
           glm::cross(axis, glm::cross(axis, v)) / (1 + glm::dot(from, to));
}

/// An edge of a cage, with the faces on its two sides.
struct CageEdge {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t face[2];
};

/// The edges in the order in which faces first meet them, and the edge that follows each corner of
/// each face.
struct CageEdges {
    std::vector<CageEdge> edges;
    std::vector<std::vector<std::uint32_t>> after_corner;
};

CageEdges edges_of(const Cage& cage) {
    struct Side {
        std::pair<std::uint32_t, std::uint32_t> ends;
        std::uint32_t face;
        std::uint32_t corner;
    };
    std::vector<Side> sides;
    CageEdges result;
    for (std::uint32_t f = 0; f < cage.faces.size(); ++f) {
        const Cage::Face& face = cage.faces[f];
        result.after_corner.emplace_back(face.size());
        for (std::uint32_t i = 0; i < face.size(); ++i)
            sides.push_back(
                {std::minmax<std::uint32_t>(face[i], face[(i + 1) % face.size()]), f, i});
    }
    std::ranges::stable_sort(sides, [](const Side& a, const Side& b) { return a.ends < b.ends; });
    assert(sides.size() % 2 == 0);
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        const Side& one = sides[i];
        const Side& other = sides[i + 1];
        assert(one.ends == other.ends);
        const auto number = static_cast<std::uint32_t>(result.edges.size());
        result.after_corner[one.face][one.corner] = number;
        result.after_corner[other.face][other.corner] = number;
        result.edges.push_back({one.ends.first, one.ends.second, {one.face, other.face}});
    }
    return result;
}

/// Where the old points move to: (mean of face points + 2 mean of edge middles + (n - 3) P) / n.
std::vector<glm::dvec3> moved_points(const Cage& cage,
                                     const CageEdges& edges,
                                     const std::vector<glm::dvec3>& face_points) {
    const std::size_t count = cage.points.size();
    std::vector<glm::dvec3> faces(count, glm::dvec3(0));
    std::vector<glm::dvec3> middles(count, glm::dvec3(0));
    std::vector<double> valence(count, 0);
    for (std::size_t f = 0; f < cage.faces.size(); ++f) {
        for (const auto corner : cage.faces[f])
            faces[corner] += face_points[f];
    }
    for (const CageEdge& edge : edges.edges) {
        const glm::dvec3 middle = (cage.points[edge.low] + cage.points[edge.high]) * 0.5;
        for (const auto end : {edge.low, edge.high}) {
            middles[end] += middle;
            valence[end] += 1;
        }
    }
    std::vector<glm::dvec3> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double n = valence[i];
        points[i] = (faces[i] / n + middles[i] * (2 / n) + cage.points[i] * (n - 3)) / n;
    }
    return points;
}

Cage subdivided_once(const Cage& cage) {
    const CageEdges edges = edges_of(cage);
    std::vector<glm::dvec3> face_points;
    for (const Cage::Face& face : cage.faces)
        face_points.push_back(centre_of(cage, face));
    Cage finer;
    finer.points = moved_points(cage, edges, face_points);
    const auto first_edge = static_cast<std::uint32_t>(finer.points.size());
    for (const CageEdge& edge : edges.edges) {
        finer.points.push_back((cage.points[edge.low] + cage.points[edge.high] +
                                face_points[edge.face[0]] + face_points[edge.face[1]]) *
                               0.25);
    }
    const auto first_face = static_cast<std::uint32_t>(finer.points.size());
    finer.points.insert(finer.points.end(), face_points.begin(), face_points.end());
    for (std::uint32_t f = 0; f < cage.faces.size(); ++f) {
        const Cage::Face& face = cage.faces[f];
        const auto& after = edges.after_corner[f];
        for (std::size_t i = 0; i < face.size(); ++i) {
            const auto before = after[(i + face.size() - 1) % face.size()];
            finer.faces.push_back(
                {face[i], first_edge + after[i], first_face + f, first_edge + before});
        }
    }
    return finer;
}

}  // namespace

Cage cage_of_rings(std::span<const Ring> rings) {
    assert(rings.size() >= 2);
    const auto n = static_cast<std::uint32_t>(rings[0].size());
    Cage cage;
    for (const Ring& ring : rings) {
        assert(ring.size() == n);
        cage.points.insert(cage.points.end(), ring.begin(), ring.end());
    }
    for (std::uint32_t low = 0; low + n < cage.points.size(); low += n) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t next = (i + 1) % n;
            cage.faces.push_back({low + i, low + next, low + n + next, low + n + i});
        }
    }
    Cage::Face bottom(n);
    Cage::Face top(n);
    std::iota(top.begin(), top.end(), static_cast<std::uint32_t>(cage.points.size()) - n);
    std::iota(bottom.rbegin(), bottom.rend(), 0U);
    cage.faces.push_back(std::move(bottom));
    cage.faces.push_back(std::move(top));
    return cage;
}

void pull(Cage& cage, std::size_t face, std::span<const TubeNode> stations) {
    glm::dvec3 centre = centre_of(cage, cage.faces[face]);
    glm::dvec3 direction = normal_of(cage, cage.faces[face]);
    for (std::size_t s = 0; s < stations.size(); ++s) {
        const auto& from = s == 0 ? centre : stations[s - 1].center;
        const auto& to = stations[s + 1 < stations.size() ? s + 1 : s].center;
        const glm::dvec3 next = glm::normalize(to - from);
        const Cage::Face old = cage.faces[face];
        double reach = 0;
        for (const auto corner : old)
            reach += glm::distance(cage.points[corner], centre);
        const double scale = stations[s].radius * static_cast<double>(old.size()) / reach;
        Cage::Face pulled;
        for (const auto corner : old) {
            const glm::dvec3 arm = carried(cage.points[corner] - centre, direction, next);
            pulled.push_back(static_cast<std::uint32_t>(cage.points.size()));
            cage.points.push_back(stations[s].center + arm * scale);
        }
        for (std::size_t i = 0; i < old.size(); ++i) {
            const std::size_t j = (i + 1) % old.size();
            cage.faces.push_back({old[i], old[j], pulled[j], pulled[i]});
        }
        cage.faces[face] = pulled;
        centre = stations[s].center;
        direction = next;
    }
}

scene::Mesh subdivided(const Cage& cage, int levels) {
    assert(levels >= 1);
    Cage finest = subdivided_once(cage);
    for (int level = 1; level < levels; ++level)
        finest = subdivided_once(finest);
    scene::Mesh mesh;
    for (const auto& p : finest.points)
        mesh.positions.emplace_back(snapped(p));
    for (const Cage::Face& face : finest.faces) {
        mesh.triangles.push_back({face[0], face[1], face[2]});
        mesh.triangles.push_back({face[0], face[2], face[3]});
    }
    return mesh;
}

}  // namespace ink::catalogue
