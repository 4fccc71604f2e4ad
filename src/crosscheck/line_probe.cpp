#include "crosscheck/line_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "crosscheck/line_names.h"
#include "crosscheck/sight_rays.h"
#include "scene/precision/weld_tolerance.h"
#include "scene/predicates.h"

namespace ink::crosscheck {
namespace {

/// Sees without Embree: tries every triangle near a point, in double, with exact predicates for
/// what holds it. Slow, so for a few places alone.
class PlainRays final : public SightRays {
  public:
    /// Sorts the triangles that may be seen within kReach_px of `places_px` into their pixels.
    PlainRays(const ClipMesh& mesh, std::span<const glm::dvec2> places_px);

    static constexpr double kReach_px = 1.0 / 64;

    /// For points within kReach_px of a place; others see the sky.
    [[nodiscard]] Sight look(const glm::dvec2& p_px) const override;
    /// The triangles that may be seen in the pixel of a point, hidden ones too; none for pixels
    /// without a place.
    [[nodiscard]] std::span<const std::uint32_t> faces_near(const glm::dvec2& p_px) const;

  private:
    [[nodiscard]] bool is_met(std::uint32_t face, const scene::SightLine& ray) const;

    std::vector<std::uint64_t> pixels_;              ///< keys of those with a place, ascending
    std::vector<std::vector<std::uint32_t>> faces_;  ///< per pixel
};

constexpr double kExact_px = 1e-9;  ///< by so much double may miss on the way along a face

constexpr double kFarOff_px = 1e9;

/// Ascending by rows.
std::uint64_t key_of(double x_px, double y_px) {
    const auto part = [](double v) {
        return static_cast<std::uint64_t>(std::floor(std::clamp(v, -kFarOff_px, kFarOff_px)) +
                                          kFarOff_px);
    };
    return part(y_px) << 32U | part(x_px);
}

struct Box {
    glm::dvec2 low{-kFarOff_px}, high{kFarOff_px};
};

/// Where a face may be on the image; anywhere, if the near plane cuts it.
Box box_of(const ClipMesh& mesh, const scene::Face& face) {
    Box box{glm::dvec2(kFarOff_px), glm::dvec2(-kFarOff_px)};
    for (const std::uint32_t v : face.vertices) {
        const glm::dvec3& p = mesh.p_clip()[v];
        if (p.z < mesh.view().camera.near) return {};
        const glm::dvec2 at = glm::dvec2(p) / p.z;
        box.low = glm::min(box.low, at);
        box.high = glm::max(box.high, at);
    }
    return {box.low - PlainRays::kReach_px, box.high + PlainRays::kReach_px};
}

/// The distance along the view direction at which the ray, of unit depth, meets the face's plane.
double depth_of(const ClipMesh& mesh, const scene::Face& face, const scene::SightLine& ray) {
    const auto& p = mesh.topology().p_world;
    const auto& v = face.vertices;
    const glm::dvec3 n = glm::cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]);
    const double along = glm::dot(n, ray.way_world);
    return along != 0 ? glm::dot(n, p[v[0]] - ray.begin_world) / along : 0;
}

PlainRays::PlainRays(const ClipMesh& mesh, std::span<const glm::dvec2> places_px)
    : SightRays(mesh, kExact_px) {
    for (const glm::dvec2& p : places_px) {
        for (const double dx : {-kReach_px, kReach_px}) {
            for (const double dy : {-kReach_px, kReach_px})
                pixels_.push_back(key_of(p.x + dx, p.y + dy));
        }
    }
    std::ranges::sort(pixels_);
    pixels_.erase(std::unique(pixels_.begin(), pixels_.end()), pixels_.end());
    faces_.resize(pixels_.size());
    if (pixels_.empty()) return;
    const auto& faces = mesh.topology().faces;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const Box box = box_of(mesh, faces[f]);
        auto at = std::ranges::lower_bound(pixels_, key_of(box.low.x, box.low.y));
        const std::uint64_t last = key_of(box.high.x, box.high.y);
        const std::uint64_t left = key_of(box.low.x, 0) & 0xffffffffU;
        const std::uint64_t right = last & 0xffffffffU;
        while (at != pixels_.end() && *at <= last) {
            const std::uint64_t row = *at & ~std::uint64_t{0xffffffffU}, x = *at & 0xffffffffU;
            if (x < left) {
                at = std::lower_bound(at, pixels_.end(), row | left);
            } else if (x > right) {
                at = std::lower_bound(at, pixels_.end(), row + (std::uint64_t{1} << 32U) + left);
            } else {
                faces_[static_cast<std::size_t>(at - pixels_.begin())].push_back(f);
                ++at;
            }
        }
    }
}

bool PlainRays::is_met(std::uint32_t face, const scene::SightLine& ray) const {
    const auto& v = mesh().topology().faces[face].vertices;
    const auto& p = mesh().topology().p_world;
    // A point of the ray about as far off as the face: near the eye it would lie beside the ray.
    const double far = std::max(std::abs(mesh().p_clip()[v[0]].z), mesh().view().camera.near);
    const glm::dvec3 on_ray = ray.begin_world + far * ray.way_world;
    int low = 0, high = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const int side =
            scene::facing(on_ray, p[v[i]], p[v[(i + 1) % 3]], mesh().projection().viewpoint());
        low = std::min(low, side);
        high = std::max(high, side);
    }
    return low == 0 || high == 0;
}

std::span<const std::uint32_t> PlainRays::faces_near(const glm::dvec2& p_px) const {
    const std::uint64_t key = key_of(p_px.x, p_px.y);
    const auto at = std::ranges::lower_bound(pixels_, key);
    if (at == pixels_.end() || *at != key) return {};
    return faces_[static_cast<std::size_t>(at - pixels_.begin())];
}

Sight PlainRays::look(const glm::dvec2& p_px) const {
    const scene::Projection& projection = mesh().projection();
    const scene::SightLine ray{projection.ray_begin_world(p_px.x, p_px.y),
                               projection.ray_world(p_px.x, p_px.y)};
    Foremost foremost;
    for (const std::uint32_t face : faces_near(p_px)) {
        const double depth = depth_of(mesh(), mesh().topology().faces[face], ray);
        const double w = projection.w_of(depth);
        if (depth < mesh().view().camera.near || !foremost.may_take(w)) continue;
        if (is_met(face, ray)) foremost.add(mesh(), {face, w});
    }
    return foremost.seen();
}

constexpr std::array<double, 7> kRadii_px{
    0x1p-9, 0x1p-12, 0x1p-16, 0x1p-20, 0x1p-24, 0x1p-28, 0x1p-32};
constexpr int kDirections = 8;
constexpr double kTurn_rad = 0.1;  ///< lines along the axes pass between the directions

/// Whether the two samples of one of the directions are separated by a line of the class.
bool sees_line(const PlainRays& rays, const ClaimedPoint& claim, double radius_px) {
    for (int i = 0; i < kDirections; ++i) {
        const double angle = kTurn_rad + std::numbers::pi * i / kDirections;
        const glm::dvec2 d = radius_px * glm::dvec2(std::cos(angle), std::sin(angle));
        const Sample a{claim.p_px - d, rays.look(claim.p_px - d)};
        const Sample b{claim.p_px + d, rays.look(claim.p_px + d)};
        if (is_joined(rays.mesh(), a, b)) continue;
        const Between between = name_between(rays, a, b);
        const auto* end = between.lines.data() + between.count;
        if (std::any_of(between.lines.data(), end, [&](const NamedLine& line) {
                return line.line_class == claim.line_class;
            }))
            return true;
    }
    return false;
}

constexpr double kClaimed_px = 1.0 / 512;  ///< so well is the place of a claim known

/// How many corners two faces share, and one of them.
struct Shared {
    int count = 0;
    std::uint32_t vertex = 0;
};

Shared shared_by(const scene::Face& f, const scene::Face& g) {
    Shared shared;
    for (const std::uint32_t v : f.vertices) {
        if (std::ranges::find(g.vertices, v) == g.vertices.end()) continue;
        ++shared.count;
        shared.vertex = v;
    }
    return shared;
}

class Places {
  public:
    explicit Places(const PlainRays& rays) : rays_(rays), mesh_(rays.mesh()) {}

    [[nodiscard]] bool is_open(const glm::dvec2& p_px) const {
        if (is_open_at(p_px, p_px)) return true;
        for (int i = 0; i < kDirections; ++i) {
            const double angle = 2 * std::numbers::pi * i / kDirections;
            const glm::dvec2 d(std::cos(angle), std::sin(angle));
            if (is_open_at(p_px + scene::kUnseen_px * d, p_px)) return true;
        }
        return false;
    }

  private:
    /// Whether another surface lies on the one that is seen at `at_px`, beside the place.
    [[nodiscard]] bool is_open_at(const glm::dvec2& at_px, const glm::dvec2& place_px) const {
        const Sight sight = rays_.look(at_px);
        if (sight.face == kNothing) return false;
        const scene::Projection& projection = mesh_.projection();
        const double px_world = 1 / projection.px_per_world(sight.w);
        const double of_seen = written(sight.face, px_world);
        if (of_seen < 0) return false;
        const glm::dvec3 p_world = projection.at(at_px.x, at_px.y, projection.depth_of(sight.w));
        const auto& faces = rays_.faces_near(place_px);
        return std::ranges::any_of(faces, [&](std::uint32_t other) {
            const double of_other = written(other, px_world);
            if (other == sight.face || of_other < 0) return false;
            const double reach = of_seen + of_other + kClaimed_px * px_world;
            if (!mesh_.is_near(other, p_world, {reach, 0})) return false;
            const auto& all = mesh_.topology().faces;
            const Shared shared = shared_by(all[sight.face], all[other]);
            if (shared.count != 1) return shared.count == 0;
            return glm::length(mesh_.topology().p_world[shared.vertex] - p_world) > 4 * reach;
        });
    }
    /// How far digits may have moved a face, less than 0 if the image may show it.
    [[nodiscard]] double written(std::uint32_t face, double px_world) const {
        const scene::Topology& topology = mesh_.topology();
        const double most = std::max(topology.written_rounding_world[topology.faces[face].object],
                                     topology.rounding_of(face));
        return most < scene::kUnseen_px * px_world ? most : -1;
    }

    const PlainRays& rays_;
    const ClipMesh& mesh_;
};

/// What `judge(rays, claim)` says of each.
template <class Judge>
std::vector<char> judge_all(const scene::Topology& topology,
                            const scene::View& view,
                            const SamplingOptions& options,
                            std::span<const ClaimedPoint> claims,
                            const Judge& judge) {
    std::vector<char> judged(claims.size(), 0);
    if (claims.empty()) return judged;
    const ClipMesh mesh(topology, view, options);
    std::vector<glm::dvec2> places;
    for (const ClaimedPoint& claim : claims)
        places.push_back(claim.p_px);
    const PlainRays rays(mesh, places);
    core::parallel_for(
        claims.size(), options.threads, [&](std::size_t i) { judged[i] = judge(rays, claims[i]); });
    return judged;
}

bool is_of_class(const ClipMesh& mesh, const ClaimedEdge& claim) {
    const scene::Edge& edge = mesh.topology().edges[claim.edge];
    return std::ranges::any_of(mesh.topology().faces_of(edge), [&](std::uint32_t face) {
        const std::size_t side = scene::side_at(mesh.topology().faces[face], claim.edge);
        return mesh.across(face, side).line_class == claim.line_class;
    });
}

}  // namespace

std::vector<char> see_claimed_lines(const scene::Topology& topology,
                                    const scene::View& view,
                                    const SamplingOptions& options,
                                    std::span<const ClaimedPoint> claims) {
    const auto is_seen = [](const PlainRays& rays, const ClaimedPoint& claim) {
        return std::ranges::any_of(
            kRadii_px, [&](double radius_px) { return sees_line(rays, claim, radius_px); });
    };
    return judge_all(topology, view, options, claims, is_seen);
}

std::vector<char> name_claimed_edges(const scene::Topology& topology,
                                     const scene::View& view,
                                     const SamplingOptions& options,
                                     std::span<const ClaimedEdge> claims) {
    std::vector<char> is_named;
    if (claims.empty()) return is_named;
    const ClipMesh mesh(topology, view, options);
    for (const ClaimedEdge& claim : claims)
        is_named.push_back(is_of_class(mesh, claim) ? 1 : 0);
    return is_named;
}

std::vector<char> find_open_places(const scene::Topology& topology,
                                   const scene::View& view,
                                   const SamplingOptions& options,
                                   std::span<const ClaimedPoint> claims) {
    if (topology.written_rounding_world.empty()) return std::vector<char>(claims.size(), 0);
    return judge_all(
        topology, view, options, claims, [](const PlainRays& rays, const ClaimedPoint& claim) {
            return Places(rays).is_open(claim.p_px);
        });
}

}  // namespace ink::crosscheck
