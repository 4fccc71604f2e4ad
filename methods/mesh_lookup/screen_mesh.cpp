#include "methods/mesh_lookup/screen_mesh.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "core/parallel.h"
#include "raster/pass/screen_vertex.h"
#include "raster/pass/view_transform.h"
#include "scene/predicates.h"
#include "scene/topology.h"

namespace ink::methods {
namespace {

constexpr double kBeyond_px = 1.0 / 256;  ///< a face this far beyond the far sample is met there
constexpr double kCrack_px = 1.0 / 64;    ///< boundaries this near are the same to any eye
constexpr double kCrackDepth = 1e-4;      ///< relative: two boundaries this far apart meet
constexpr double kSameDepth = 1e-6;       ///< relative: what the depth test cannot tell
constexpr double kFarBehind = 1e-2;       ///< relative: more than rounding moves a surface by
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
    each_batch(is_cut_.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const LookupFace& face = mesh_->faces[f];
            const auto is_beside = [&](Twin twin) {
                return !twin.is_nothing() && !twin.is_many() &&
                       reaches_near(mesh_->faces[twin.face()]);
            };
            is_cut_[f] = reaches_near(face) || std::ranges::any_of(face.twins, is_beside);
        }
    });
}

/// One walk over the mesh along the line of samples from s = 0 to 1.
class ScreenMesh::Walk {
  public:
    enum class End {
        arrived,  ///< at the other face
        line,     ///< at an edge that is one
        beyond,   ///< past the other sample, on another surface
        hidden,   ///< at an edge of many, of whose faces another hides the walk's
        cut,      ///< at the near plane
        lost,     ///< nowhere: too many steps, or the face does not hold its sample
    };

    /// From the first sample to the second, or back.
    Walk(const ScreenMesh& screen, const SampleSide& side, bool is_back)
        : screen_(screen),
          is_down_(side.is_down),
          sign_(is_back ? -1 : 1),
          x_(side.x + (is_back && !side.is_down ? 1 : 0)),
          y_(side.y + (is_back && side.is_down ? 1 : 0)),
          at_(is_back ? side.second : side.first),
          goal_(is_back ? side.first : side.second) {
        if (at_ != kNoNeighbour) run();
    }

    [[nodiscard]] End end() const { return end_; }
    [[nodiscard]] LineKind kind() const { return kind_; }
    [[nodiscard]] double s() const { return s_; }
    [[nodiscard]] double q() const { return q_; }
    /// The last face.
    [[nodiscard]] std::uint32_t face() const { return at_; }

    /// 1/w of the surface at s, nothing where the walk did not come or is not known.
    [[nodiscard]] std::optional<double> q_at(double s) const {
        if (end_ == End::line && s > s_) return std::nullopt;
        for (std::size_t i = 0; i < piece_count_; ++i) {
            const Piece& piece = pieces_[i];
            if (s > piece.s1 && i + 1 < piece_count_) continue;
            const double length = piece.s1 - piece.s0;
            if (!(length > 0)) return piece.q0;
            return piece.q0 + (piece.q1 - piece.q0) * (s - piece.s0) / length;
        }
        return std::nullopt;
    }

  private:
    /// A crossing of the line with an edge, from its end above the line to that below.
    struct Passage {
        std::uint32_t high = 0;
        std::uint32_t low = 0;
        double s = 0;
        double q = 0;  ///< 1/w; 0 behind the eye
        double w = 0;  ///< not above 0 behind the eye
        double u = 0;  ///< s w, which holds there, too

        /// Whether the line meets this edge of a face behind that one, for w of either sign.
        [[nodiscard]] bool is_ahead_of(const Passage& other) const {
            return u * other.w > other.u * w;
        }
    };
    struct Piece {
        double s0, q0, s1, q1;
    };
    /// A face and the edge over which the walk came to it.
    struct Landing {
        std::uint32_t face = kNoNeighbour;
        std::size_t edge = 0;
    };

    /// A sample counts as lying a little to the right of where it is and below, as the rasterizer's
    /// rule has it: what lies on the line is above it.
    [[nodiscard]] bool is_high(std::uint32_t vertex) const { return height(vertex) > 0; }

    [[nodiscard]] double height(std::uint32_t vertex) const {
        const Vertex v = screen_.vertex(vertex);
        if (v.is_on_screen()) return is_down_ ? v.x - 256 * x_ - 128 : v.y - 256 * y_ - 128;
        const glm::dvec3 p = screen_.p_clip(vertex);
        return is_down_ ? p.x - (x_ + 0.5) * p.z : p.y - (y_ + 0.5) * p.z;
    }

    [[nodiscard]] Passage passage(std::uint32_t high, std::uint32_t low) const {
        const Vertex a = screen_.vertex(high);
        const Vertex b = screen_.vertex(low);
        Passage at{high, low};
        if (a.is_on_screen() && b.is_on_screen()) {
            const double ha = height(high), hb = height(low);
            const double t = ha > hb ? std::clamp(ha / (ha - hb), 0.0, 1.0) : 0.5;
            const double from = is_down_ ? a.y - 256.0 * y_ - 128 : a.x - 256.0 * x_ - 128;
            const double to = is_down_ ? b.y - 256.0 * y_ - 128 : b.x - 256.0 * x_ - 128;
            at.s = sign_ * (from + t * (to - from)) / 256;
            at.q = a.q + t * (b.q - a.q);
            at.w = 1 / at.q;
            at.u = at.s * at.w;
            return at;
        }
        const double place = is_down_ ? x_ + 0.5 : y_ + 0.5;
        const glm::dvec3 begin = screen_.p_clip(high), end = screen_.p_clip(low);
        const auto clip_height = [&](const glm::dvec3& p) {
            return (is_down_ ? p.x : p.y) - place * p.z;
        };
        const double ha = clip_height(begin), hb = clip_height(end);
        const double t = ha != hb ? std::clamp(ha / (ha - hb), 0.0, 1.0) : 0.5;
        const glm::dvec3 p = begin + t * (end - begin);
        at.w = p.z;
        at.u = sign_ * ((is_down_ ? p.y : p.x) - (0.5 + (is_down_ ? y_ : x_)) * p.z);
        at.q = at.w > 0 ? 1 / at.w : 0;
        at.s = at.w > 0 ? at.u / at.w : std::numeric_limits<double>::infinity();
        return at;
    }

    /// Edge i of the face; its crossing if its ends lie on both sides.
    [[nodiscard]] std::optional<Passage> crossing(const LookupFace& face, std::size_t i) const {
        const std::uint32_t a = face.vertices[i], b = face.vertices[(i + 1) % 3];
        const bool is_a_high = is_high(a);
        if (is_a_high == is_high(b)) return std::nullopt;
        return is_a_high ? passage(a, b) : passage(b, a);
    }

    void run() {
        std::size_t exit = 0;
        Passage in, out;
        if (!start(exit, in, out)) return;
        for (int step = 0; step < screen_.options_.most_steps; ++step) {
            note(in, out);
            if (out.q * screen_.near_ > 1 || out.q <= 0) {
                end_ = End::cut;
                return;
            }
            if (out.s > 1 + kBeyond_px) {
                end_ = End::beyond;
                return;
            }
            const Landing next = across(exit, out);
            if (end_ == End::hidden) return;
            if (kind_ != LineKind::none) {
                end_ = End::line;
                s_ = out.s;
                q_ = out.q;
                return;
            }
            at_ = next.face;
            if (at_ == goal_) {
                end_ = End::arrived;
                return;
            }
            in = out;
            exit = leave(next.edge, out);
        }
    }

    /// Where the line leaves the first face.
    bool start(std::size_t& exit, Passage& in, Passage& out) const {
        const LookupFace& face = screen_.mesh_->faces[at_];
        int found = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = crossing(face, i);
            if (!at) continue;
            if (found == 0 || at->is_ahead_of(out)) {
                in = out;
                out = *at;
                exit = i;
            } else {
                in = *at;
            }
            ++found;
        }
        return found == 2;
    }

    /// Over which edge the line leaves a face that it entered over another: over that of the two
    /// whose ends lie on both sides; where, in `out`.
    std::size_t leave(std::size_t entered, Passage& out) const {
        const LookupFace& face = screen_.mesh_->faces[at_];
        std::uint32_t high = face.vertices[entered];
        std::uint32_t low = face.vertices[(entered + 1) % 3];
        std::size_t of_high = (entered + 2) % 3, of_low = (entered + 1) % 3;  // edges to the third
        if (height(high) < height(low)) {
            std::swap(high, low);
            std::swap(of_high, of_low);
        }
        const std::uint32_t third = face.vertices[(entered + 2) % 3];
        const bool is_third_high = is_high(third);
        out = is_third_high ? passage(third, low) : passage(high, third);
        return is_third_high ? of_low : of_high;
    }

    void note(const Passage& in, const Passage& out) {
        const Piece piece{in.s, in.q, out.s, out.q};
        if (piece_count_ < pieces_.size()) {
            pieces_[piece_count_++] = piece;
        } else {
            pieces_.back() = piece;
        }
    }

    [[nodiscard]] glm::dvec3 p_world(std::uint32_t vertex) const {
        return screen_.mesh_->p_world[vertex];
    }

    /// The face on the other side of an edge that is left, or the line that it is, in kind_.
    Landing across(std::size_t exit, const Passage& out) {
        const LookupFace& face = screen_.mesh_->faces[at_];
        const Twin twin = face.twins[exit];
        if (twin.is_nothing()) {
            kind_ = LineKind::boundary;
            return {};
        }
        if (twin.is_many()) {
            const std::uint32_t mine = face.vertices[(exit + 2) % 3];
            return nearest_of_many(exit, out, screen_.side_of(out.high, out.low, mine));
        }
        kind_ = screen_.is_open(at_, twin) ? face.kinds[exit] : LineKind::contour;
        return {twin.face(), twin.edge()};
    }

    /// How fast 1/w grows from an edge into a face, per px.
    [[nodiscard]] double slope(const Passage& out, std::uint32_t third) const {
        const Vertex a = screen_.vertex(out.high);
        const Vertex b = screen_.vertex(out.low);
        const Vertex c = screen_.vertex(third);
        if (!a.is_on_screen() || !b.is_on_screen() || !c.is_on_screen()) return 0;
        const double ex = b.x - a.x, ey = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
        const double length2 = ex * ex + ey * ey;
        const double distance = std::abs(ex * cy - ey * cx);
        if (!(length2 > 0) || !(distance > 0)) return 0;
        const double foot = a.q + (b.q - a.q) * (ex * cx + ey * cy) / length2;
        return (c.q - foot) * std::sqrt(length2) / distance;
    }

    /// Of several faces beyond an edge that nearest the eye.
    Landing nearest_of_many(std::size_t exit, const Passage& out, int mine) {
        const std::uint32_t low = std::min(out.high, out.low), high = std::max(out.high, out.low);
        const auto& many = screen_.mesh_->many;
        const glm::dvec3 a = p_world(out.high), b = p_world(out.low);
        std::uint32_t best = kNoNeighbour;
        std::size_t best_third = 0;
        double best_slope = 0;
        const double own_slope = slope(out, screen_.mesh_->faces[at_].vertices[(exit + 2) % 3]);
        // Faces that lie on each other hide nothing, whichever rounding on the screen puts in
        // front.
        const glm::dvec3 n = glm::normalize(
            glm::cross(b - a, p_world(screen_.mesh_->faces[at_].vertices[(exit + 2) % 3]) - a));
        const double tolerance = screen_.mesh_->tolerance_world[screen_.mesh_->objects[at_]];
        for (auto at = std::lower_bound(many.begin(), many.end(), ManyFaces{low, high, 0});
             at != many.end() && at->a == low && at->b == high;
             ++at) {
            if (at->face == at_) continue;
            const auto& v = screen_.mesh_->faces[at->face].vertices;
            const auto third = static_cast<std::size_t>(
                std::find_if(
                    v.begin(), v.end(), [&](std::uint32_t i) { return i != low && i != high; }) -
                v.begin());
            const int beside = mine * screen_.side_of(out.high, out.low, v[third]);
            if (beside == 0) continue;
            const double grows = slope(out, v[third]);
            if (beside > 0) {
                const bool is_apart = std::abs(glm::dot(n, p_world(v[third]) - a)) > tolerance;
                if (is_apart && grows > own_slope) end_ = End::hidden;
                continue;
            }
            if (best != kNoNeighbour && grows <= best_slope) continue;
            best = at->face;
            best_third = third;
            best_slope = grows;
        }
        if (best == kNoNeighbour) {
            kind_ = LineKind::contour;
            return {};
        }
        const LookupFace& face = screen_.mesh_->faces[at_];
        const double deviation =
            scene::deviation_rad({a, b, p_world(face.vertices[(exit + 2) % 3])},
                                 {a, b, p_world(screen_.mesh_->faces[best].vertices[best_third])});
        if (deviation >= screen_.options_.crease_rad) {
            kind_ = LineKind::crease;
        } else if (screen_.mesh_->objects[at_] != screen_.mesh_->objects[best]) {
            kind_ = LineKind::seam;
        }
        return {best, (best_third + 1) % 3};
    }

    const ScreenMesh& screen_;

    bool is_down_;
    int sign_;
    int x_, y_;
    std::uint32_t at_, goal_;
    End end_ = End::lost;
    LineKind kind_ = LineKind::none;
    double s_ = 0, q_ = 0;
    std::array<Piece, 16> pieces_;
    std::size_t piece_count_ = 0;
};

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
    const LookupFace& f = mesh_->faces[there.face()];
    const LookupFace& g = mesh_->faces[back.face()];
    const double w = projection_->depth_of(1 / there.q());
    const double gap = std::abs(w - projection_->depth_of(1 / back.q()));
    const double crack = mesh_->crack_world[mesh_->objects[there.face()]];
    if (gap > std::max(crack, kCrackDepth * w)) return false;
    const auto normal = [&](const LookupFace& face) {
        const auto& p = mesh_->p_world;
        const auto& v = face.vertices;
        return glm::normalize(glm::cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]));
    };
    return std::abs(glm::dot(normal(f), normal(g))) > std::cos(options_.crease_rad);
}

FoundLine ScreenMesh::between_surfaces(const SampleSide& side,
                                       const Walk& there,
                                       const Walk& back) const {
    using End = Walk::End;
    const bool has_first = there.end() == End::line, has_second = back.end() == End::line;
    // Where a walk comes past the other sample no farther off than what is seen there, the surface
    // goes on: both coincide, or the other is seen through a crack.
    // (What is far behind covers nothing.)
    const auto is_far_behind = [](const Walk& walk, const Walk& other) {
        const auto mine = walk.q_at(1), seen = other.q_at(0);
        return mine && seen && *mine < *seen * (1 - kFarBehind);
    };
    const auto goes_on = [&](const Walk& walk, const Walk& other, bool is_second) {
        return walk.end() == End::beyond && !is_far_behind(walk, other) &&
               covers(side, is_second, is_second ? side.second : side.first, walk.face());
    };
    const bool goes_there = goes_on(there, back, true), goes_back = goes_on(back, there, false);
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
    const auto is_in_front = [](const Walk& walk, const Walk& other) {
        const auto q = other.q_at(1 - walk.s());
        return !q || walk.q() >= *q * (1 - kSameDepth);
    };
    const bool is_first = has_first && is_in_front(there, back);
    const bool is_second = has_second && is_in_front(back, there);
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
