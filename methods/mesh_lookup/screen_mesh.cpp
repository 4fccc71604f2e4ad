#include "methods/mesh_lookup/screen_mesh.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/parallel.h"
#include "methods/mesh_lookup/screen_walk.h"
#include "raster/pass/screen_vertex.h"
#include "scene/predicates.h"

namespace ink::methods {
namespace {

constexpr double kCrack_px = 1.0 / 64;  ///< boundaries this near are the same to any eye
constexpr double kCrackDepth = 1e-4;    ///< relative: two boundaries this far apart meet
constexpr double kFarBehind = 1e-2;     ///< relative: more than rounding moves a surface by
constexpr std::size_t kBatch = 4096;

/// Calls use(begin, end) for parts of 0..count, from several threads.
template <class Use>
void each_batch(std::size_t count, int threads, Use use) {
    core::parallel_for((count + kBatch - 1) / kBatch, threads, [&](std::size_t batch) {
        use(batch * kBatch, std::min(count, (batch + 1) * kBatch));
    });
}

}  // namespace

void ScreenMesh::see(const LookupMesh& mesh,
                     const scene::View& view,
                     const WalkOptions& options,
                     int threads) {
    mesh_ = &mesh;
    options_ = options;
    projection_.emplace(view);
    eye_ = view.camera.viewpoint();
    near_ = view.camera.near;
    transform_ = raster::ViewTransform(view);
    q_.resize(mesh.p_world.size());
    places_.resize(mesh.p_world.size());
    facing_.resize(mesh.faces.size());
    is_cut_.clear();
    std::atomic<bool> reaches_near = false;
    each_batch(q_.size(), threads, [&](std::size_t begin, std::size_t end) {
        const std::span all(mesh.p_world), part = all.subspan(begin, end - begin);
        if (to_screen(part,
                      transform_,
                      near_,
                      std::span(q_).subspan(begin, part.size()),
                      std::span(places_).subspan(begin, part.size())))
            reaches_near = true;
    });
    each_batch(facing_.size(), threads, [&](std::size_t begin, std::size_t end) {
        find_facing(mesh, eye_, begin, end, facing_);
    });
    if (reaches_near) find_cut(threads);
}

void ScreenMesh::find_cut(int threads) {
    const auto reaches_near = [&](const LookupFace& face) {
        return std::ranges::any_of(face.vertices, [&](std::uint32_t i) {
            return places_[i] == glm::ivec2(kOffScreen, kBeforeNear);
        });
    };
    is_cut_.resize(mesh_->faces.size());
    const auto is_beside = [&](Twin twin) {
        return !twin.is_nothing() && !twin.is_many() && reaches_near(mesh_->faces[twin.face()]);
    };
    core::parallel_for_chunks(is_cut_.size(), kBatch, threads, [&](std::size_t f) {
        const LookupFace& face = mesh_->faces[f];
        is_cut_[f] = reaches_near(face) || std::ranges::any_of(face.twins, is_beside);
    });
}

/// On which side of the plane through the eye and an edge a corner lies.
///
/// Most are told by where they are on the screen: each place is off by half of 1/256 px at most.
int ScreenMesh::side_of(std::uint32_t a, std::uint32_t b, std::uint32_t corner) const {
    const Vertex from = vertex(a), to = vertex(b), at = vertex(corner);
    if (from.is_on_screen() && to.is_on_screen() && at.is_on_screen()) {
        const std::int64_t ex = to.x - from.x, ey = to.y - from.y;
        const std::int64_t cx = at.x - from.x, cy = at.y - from.y;
        const std::int64_t area = ex * cy - ey * cx;
        const std::int64_t doubt =
            2 * (std::abs(ex) + std::abs(ey) + std::abs(cx) + std::abs(cy)) + 4;
        if (area > doubt) return -1;
        if (area < -doubt) return 1;
    }
    return scene::facing(mesh_->p_world[a], mesh_->p_world[b], mesh_->p_world[corner], eye_);
}

FoundLine ScreenMesh::line_between(const SampleSide& side) const {
    using End = Walk::End;
    const Walk there(*this, side, false);
    if (there.end() == End::arrived) return {};
    const Walk back(*this, side, true);
    if (back.end() == End::arrived) return {};
    if (side.first == kNoNeighbour || side.second == kNoNeighbour) {
        const Walk& walk = side.first == kNoNeighbour ? back : there;
        // A walk that comes past the sky has looked at it through a crack.
        if (walk.end() == End::cut || walk.end() == End::beyond) return {};
        if (walk.end() == End::lost) return {LineKind::contour, 0.5};
        return {walk.kind(), side.first == kNoNeighbour ? 1 - walk.s() : walk.s()};
    }
    if (there.end() == End::lost || back.end() == End::lost) {
        // Nothing is known of the way: what is left is what ids tell.
        const auto patch = [&](std::uint32_t face) { return mesh_->faces[face].patch; };
        if (patch(side.first) == patch(side.second)) return {};
    }
    return between_surfaces(side, there, back);
}

/// Whether a face covers what is seen at a sample: it is as near, as far as vertices of floats can
/// tell, or nearer.
bool ScreenMesh::covers(const SampleSide& side,
                        bool is_second,
                        std::uint32_t seen,
                        std::uint32_t other) const {
    const double x = side.x + (is_second && !side.is_down ? 1.5 : 0.5);
    const double y = side.y + (is_second && side.is_down ? 1.5 : 0.5);
    const glm::dvec3 ray = projection_->ray_world(x, y);
    const glm::dvec3 begin = projection_->ray_begin_world(x, y);
    const auto corner = [&](std::uint32_t face, std::size_t i) {
        return mesh_->p_world[mesh_->faces[face].vertices[i]] - begin;
    };
    const auto normal = [&](std::uint32_t face) {
        const glm::dvec3 a = corner(face, 0);
        return glm::normalize(glm::cross(corner(face, 1) - a, corner(face, 2) - a));
    };
    const glm::dvec3 n = normal(seen), m = normal(other);
    const double along = glm::dot(n, ray);
    if (along == 0) return false;
    const double w = glm::dot(n, corner(seen, 0)) / along;
    const double along_other = glm::dot(m, ray);
    if (along_other == 0) return false;
    const double nearer = w - glm::dot(m, corner(other, 0)) / along_other;
    const auto tolerance = [&](std::uint32_t face) {
        return mesh_->tolerance_world[mesh_->objects[face]];
    };
    return nearer * std::abs(along_other) >= -std::max(tolerance(seen), tolerance(other));
}

/// Whether the boundaries that ended two walks are the two sides of one crack, over which the
/// surface goes on: at one place, and flatter than a crease.
bool ScreenMesh::is_crack(const Walk& there, const Walk& back) const {
    if (there.kind() != LineKind::boundary || back.kind() != LineKind::boundary) return false;
    if (std::abs(there.s() - (1 - back.s())) > kCrack_px) return false;
    const double w = projection_->depth_of(1 / there.q());
    const double gap = std::abs(w - projection_->depth_of(1 / back.q()));
    const double crack = mesh_->crack_world[mesh_->objects[there.face()]];
    if (gap > std::max(crack, kCrackDepth * w)) return false;
    const double cosine = glm::dot(mesh_->normal(there.face()), mesh_->normal(back.face()));
    return std::abs(cosine) > std::cos(options_.crease_rad);
}

/// Whether a walk has come past the other sample over what is seen there, which is not far behind.
bool ScreenMesh::goes_on(const SampleSide& side,
                         const Walk& walk,
                         const Walk& other,
                         bool is_second) const {
    if (walk.end() != Walk::End::beyond) return false;
    const auto mine = walk.q_at(1), seen = other.q_at(0);
    if (mine && seen && *mine < *seen * (1 - kFarBehind)) return false;
    return covers(side, is_second, is_second ? side.second : side.first, walk.face());
}

FoundLine ScreenMesh::between_surfaces(const SampleSide& side,
                                       const Walk& there,
                                       const Walk& back) const {
    using End = Walk::End;
    const bool has_first = there.end() == End::line, has_second = back.end() == End::line;
    // Where a walk comes past the other sample no farther off than what is seen there, the surface
    // goes on: both coincide, or the other is seen through a crack.
    const bool goes_there = goes_on(side, there, back, true);
    const bool goes_back = goes_on(side, back, there, false);
    if (goes_there && goes_back) return {};
    if (goes_there || goes_back) {
        // Of two objects, the border of the one is a seam.
        const bool is_seam = (goes_there ? has_second : has_first) &&
                             mesh_->objects[side.first] != mesh_->objects[side.second];
        if (!is_seam) return {};
        return {LineKind::seam, goes_there ? 1 - back.s() : there.s()};
    }
    if (has_first && has_second && is_crack(there, back)) {
        const bool is_one = mesh_->objects[there.face()] == mesh_->objects[back.face()];
        return is_one ? FoundLine{} : FoundLine{LineKind::seam, there.s()};
    }
    const bool is_first = has_first && there.is_in_front_of(back);
    const bool is_second = has_second && back.is_in_front_of(there);
    if (is_first || is_second) {
        if (is_first && (!is_second || there.q() >= back.q())) return {there.kind(), there.s()};
        return {back.kind(), 1 - back.s()};
    }
    if (there.end() == End::cut || back.end() == End::cut) return {};
    // By how much the first surface is the nearer at either sample.
    const auto q0 = there.q_at(0), q1 = there.q_at(1);
    const auto other0 = back.q_at(1), other1 = back.q_at(0);
    if (!q0 || !q1 || !other0 || !other1) return {LineKind::intersection, 0.5};
    const double before = *q0 - *other0, after = *q1 - *other1;
    if (std::abs(before) <= kSameDepth * *q0 && std::abs(after) <= kSameDepth * *q0) return {};
    const double s = before != after ? std::clamp(before / (before - after), 0.0, 1.0) : 0.5;
    return {LineKind::intersection, s};
}

}  // namespace ink::methods
