#include "crosscheck/mesh_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ink::crosscheck {
namespace {

using namespace walking;

constexpr int kMostSteps = 512;
constexpr std::size_t kMostSpread = 128;  ///< faces that one search round a point may touch

/// The place where a way in direction `d` from the local origin meets edge `side`.
MetEdge meet(const ClipMesh& mesh,
             const LocalFace& local,
             std::uint32_t face,
             std::size_t side,
             const glm::dvec2& d) {
    const auto& v = mesh.topology().faces[face].vertices;
    const glm::dvec3 &a = local.p[side], &b = local.p[(side + 1) % 3];
    const double at_a = a.y * d.x - a.x * d.y, at_b = b.y * d.x - b.x * d.y;
    const double t = at_a == at_b ? 0.5 : std::clamp(at_a / (at_a - at_b), 0.0, 1.0);
    MetEdge met{.face = face, .side = side, .w = a.z + t * (b.z - a.z)};
    const auto& p = mesh.topology().p_world;
    // A parallel camera's clip space is not linear in the world.
    const double part = mesh.projection().is_parallel() ? t * b.z / met.w : t;
    met.p_world = glm::mix(p[v[side]], p[v[(side + 1) % 3]], part);
    const glm::dvec2 inward(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z);
    const double length = glm::length(inward) * -local.orientation;
    met.outward = length != 0 ? inward / length : glm::dvec2(1, 0);
    return met;
}

/// Through which edge a straight way from the local origin to `d` leaves the face, other than the
/// one it came by; 3 if it ends inside.
std::size_t exit_of(const LocalFace& local, std::size_t entry, const glm::dvec2& d) {
    std::size_t exit = 3;
    double first = 2;
    for (std::size_t i = 0; i < 3; ++i) {
        if (i == entry) continue;
        const glm::dvec3 &a = local.p[i], &b = local.p[(i + 1) % 3];
        const double slope = (a.y * b.z - a.z * b.y) * d.x + (a.z * b.x - a.x * b.z) * d.y;
        const double begin = local.orientation * local.area[i];
        const double end = begin + local.orientation * slope;
        if (end >= 0) continue;
        const double s = begin <= 0 ? 0 : begin / (begin - end);
        if (s >= first) continue;
        first = s;
        exit = i;
    }
    return exit;
}

/// The faces within reach of a point that can be come by from one of them, each once; those across
/// a crease or a seam too if `over_features`.
class Surroundings {
  public:
    Surroundings(const ClipMesh& mesh,
                 std::uint32_t face,
                 const glm::dvec2& p_px,
                 double reach_px,
                 bool over_features)
        : mesh_(mesh),
          p_px_(p_px),
          reach_px_(reach_px),
          over_features_(over_features),
          found_{face} {}

    /// The next face; kNothing after the last.
    std::uint32_t next() {
        if (next_ == count_) return kNothing;
        const std::uint32_t face = found_[next_++];
        for (std::size_t side = 0; side < 3; ++side) {
            const Across across = mesh_.across(face, side);
            const bool is_open = over_features_ || across.line_class == truth::LineClass::none;
            if (across.face != kNothing && is_open) add(across.face);
        }
        return face;
    }

  private:
    void add(std::uint32_t face) {
        const auto end = found_.begin() + static_cast<std::ptrdiff_t>(count_);
        if (count_ == kMostSpread || std::find(found_.begin(), end, face) != end) return;
        if (ClipMesh::holds(mesh_.local_face(face, p_px_), reach_px_)) found_[count_++] = face;
    }

    const ClipMesh& mesh_;
    glm::dvec2 p_px_;
    double reach_px_;
    bool over_features_;
    std::array<std::uint32_t, kMostSpread> found_;
    std::size_t count_ = 1;
    std::size_t next_ = 0;
};

/// Whether `goal` can be come by from `face` without leaving the reach of a point: walks end in a
/// neighbour where the point lies on an edge or a corner.
bool is_reached_round(const ClipMesh& mesh,
                      std::uint32_t face,
                      std::uint32_t goal,
                      const glm::dvec2& p_px) {
    Surroundings faces(mesh, face, p_px, kReach_px, false);
    for (std::uint32_t f = faces.next(); f != kNothing; f = faces.next()) {
        if (f == goal) return true;
    }
    return false;
}

/// Whether two walks towards each other end at borders that lie on each other, where the surface
/// goes on from one to the other without a line.
bool is_defect(const ClipMesh& mesh, const Walk& there, const Walk& back) {
    const MetEdge &a = there.met, &b = back.met;
    return a.line_class == truth::LineClass::boundary &&
           b.line_class == truth::LineClass::boundary &&
           glm::length(a.p_world - b.p_world) <= 4 * mesh.tolerance(a.face, a.w) &&
           !mesh.is_seam(a.face, b.face) &&
           mesh.goes_on(a.face, b.face, a.p_world, {mesh.tolerance(a.face, a.w), 0});
}

}  // namespace

void look_at_all(const SightRays& rays, std::span<Sample> samples) {
    constexpr std::size_t kBatch = 64;
    std::array<glm::dvec2, kBatch> points_px;
    std::array<Sight, kBatch> sights;
    for (std::size_t begin = 0; begin < samples.size(); begin += kBatch) {
        const std::size_t count = std::min(kBatch, samples.size() - begin);
        for (std::size_t i = 0; i < count; ++i)
            points_px[i] = samples[begin + i].p_px;
        rays.look_at({points_px.data(), count}, {sights.data(), count});
        for (std::size_t i = 0; i < count; ++i)
            samples[begin + i].sight = sights[i];
    }
}

double walking::slant_of(const glm::dvec2& normal) {
    const double length = std::abs(normal.x) + std::abs(normal.y);
    return length > 0 ? length / glm::length(normal) : 1;
}

Walk walking::walk(const ClipMesh& mesh, const Sample& from, const glm::dvec2& to_px, Stop stop) {
    const glm::dvec2 d = to_px - from.p_px;
    Walk result;
    result.face = from.sight.face;
    std::size_t entry = 3;
    for (int step = 0; step < kMostSteps; ++step) {
        const LocalFace local = mesh.local_face(result.face, from.p_px);
        const std::size_t exit = exit_of(local, entry, d);
        if (exit == 3) {
            result.has_arrived = true;
            return result;
        }
        const Across next = mesh.across(result.face, exit);
        const bool is_end = next.face == kNothing;
        if (next.line_class != truth::LineClass::none &&
            (is_end || result.met.line_class == truth::LineClass::none)) {
            result.met = meet(mesh, local, result.face, exit, d);
            result.met.line_class = next.line_class;
        }
        if (is_end || (stop == Stop::at_feature && next.line_class != truth::LineClass::none))
            return result;
        entry = scene::side_at(mesh.topology().faces[next.face],
                               mesh.topology().faces[result.face].edges[exit]);
        result.face = next.face;
    }
    return result;
}

Walk walking::ended_round(const ClipMesh& mesh,
                          const Walk& walk,
                          const Sample& to,
                          const glm::dvec2& d,
                          double reach_px) {
    Surroundings faces(mesh, walk.face, to.p_px, reach_px, true);
    for (std::uint32_t f = faces.next(); f != kNothing; f = faces.next()) {
        const LocalFace local = mesh.local_face(f, to.p_px);
        for (std::size_t side = 0; side < 3; ++side) {
            const Across across = mesh.across(f, side);
            if (across.face != kNothing || !ClipMesh::is_edge_near(local, side, reach_px)) continue;
            Walk ended{false, f, meet(mesh, local, f, side, d)};
            ended.met.line_class = across.line_class;
            return ended;
        }
    }
    return walk;
}

bool walking::arrives_at(const ClipMesh& mesh, const Walk& walk, const Sample& to) {
    return walk.has_arrived && (walk.face == to.sight.face ||
                                is_reached_round(mesh, walk.face, to.sight.face, to.p_px));
}

bool is_joined(const ClipMesh& mesh, const Sample& from, const Sample& to) {
    if (from.sight.face == to.sight.face) return true;
    if (from.sight.face == kNothing || to.sight.face == kNothing) return false;
    const Walk there = walk(mesh, from, to.p_px, Stop::at_feature);
    if (arrives_at(mesh, there, to)) return true;
    const Walk back = walk(mesh, to, from.p_px, Stop::at_feature);
    return arrives_at(mesh, back, from) || is_defect(mesh, there, back);
}

}  // namespace ink::crosscheck
