#include "crosscheck/line_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "crosscheck/line_names.h"
#include "crosscheck/plain_rays.h"

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

}  // namespace

std::vector<char> see_claimed_lines(const scene::Topology& topology,
                                    const scene::View& view,
                                    const SamplingOptions& options,
                                    std::span<const ClaimedPoint> claims) {
    std::vector<char> is_seen(claims.size(), 0);
    if (claims.empty()) return is_seen;
    const ClipMesh mesh(topology, view, options);
    std::vector<glm::dvec2> places;
    for (const ClaimedPoint& claim : claims)
        places.push_back(claim.p_px);
    const PlainRays rays(mesh, places);
    core::parallel_for(claims.size(), options.threads, [&](std::size_t i) {
        is_seen[i] = std::any_of(kRadii_px.begin(), kRadii_px.end(), [&](double radius_px) {
            return sees_line(rays, claims[i], radius_px);
        });
    });
    return is_seen;
}

}  // namespace ink::crosscheck
