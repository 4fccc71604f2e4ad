#include "crosscheck/line_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/parallel.h"
#include "crosscheck/line_names.h"
#include "crosscheck/plain_rays.h"
#include "scene/precision/weld_tolerance.h"

namespace ink::crosscheck {
namespace {

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
        if (std::find(g.vertices.begin(), g.vertices.end(), v) == g.vertices.end()) continue;
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
        const double px_world = sight.w / mesh_.projection().focal_px();
        const double of_seen = written(sight.face, px_world);
        if (of_seen < 0) return false;
        const glm::dvec3 p_world = mesh_.projection().eye_world() +
                                   sight.w * mesh_.projection().ray_world(at_px.x, at_px.y);
        const auto& faces = rays_.faces_near(place_px);
        return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t other) {
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
        double most = topology.written_rounding_world[topology.faces[face].object];
        for (const std::uint32_t v : topology.faces[face].vertices)
            most = std::max(most, topology.rounding_world[v]);
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
