#include "studies/axis_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "buffers/each_tile.h"
#include "buffers/full_buffers.h"
#include "core/named.h"
#include "raster/pass/pass.h"
#include "scene/box.h"
#include "scene/surface.h"

namespace ink::studies {
namespace {

// A float's rounding, many times over: what is beyond it was not rounded but lost.
constexpr float kSlack = 1e-4F;

constexpr float kSky = -7;  // no depth is

/// Looks at the pixels of a tile of a full buffer that something was drawn to.
void check_planes(const raster::Tile& tile,
                  const method::DepthCarrier& carrier,
                  CaseFaults& faults) {
    if (tile.is_empty) return;
    buffers::TileFloats buffer;
    std::array<buffers::TileFloats, 3> normal_buffers;
    const buffers::TilePlane depth =
        encoded_depth(tile, carrier, buffers::DepthSign::near_high, kSky, buffer);
    const auto normals = buffers::view_normals(tile, false, normal_buffers);
    for (int y = 0; y < tile.height_px; ++y) {
        for (int x = 0; x < tile.width_px; ++x) {
            const float d = depth.row(y)[x];
            if (d == kSky) continue;
            const glm::vec3 n{normals[0].row(y)[x], normals[1].row(y)[x], normals[2].row(y)[x]};
            faults.non_finite += std::isfinite(d) && scene::is_finite(n) ? 0 : 1;
            faults.overflow += d < -kSlack || d > 1 + kSlack ? 1 : 0;
        }
    }
}

/// The planes of a full buffer with depth in one encoding.
CaseFaults count_planes(const scene::Scene& scene,
                        const scene::View& view,
                        raster::DepthEncoding encoding) {
    buffers::InputParams params;
    params.depth_encoding = encoding;
    buffers::FullBuffers buffers(params, 0);
    buffers.prepare(scene);
    buffers.pose(scene);
    if (buffers.is_empty()) return {};
    const method::Frame frame{view, 1, raster::SkipSet::none()};
    const method::DepthCarrier carrier = buffers.see(frame);
    CaseFaults faults;
    buffers::EachTile check([&](const raster::Tile& tile) { check_planes(tile, carrier, faults); });
    edge::EdgeImage out(view.width_px, view.height_px);
    (void)buffers.draw(frame, carrier, kSky, check, out);
    return faults;
}

/// Whether no depth and no normal can take the code beyond its bits.
bool fits_its_bits(const method::LinearCode& code) {
    double least = code.offset;
    double most = code.offset;
    for (const double weight :
         {code.depth_weight, code.normal_weight[0], code.normal_weight[1], code.normal_weight[2]}) {
        least += std::min(weight, 0.0);
        most += std::max(weight, 0.0);
    }
    return least >= -0.5 && most < std::ldexp(1, code.bits) - 0.5;
}

}  // namespace

CaseFaults count_inputs(const scene::Scene& scene, const scene::View& view) {
    CaseFaults counts;
    const scene::Projection projection(view);
    const scene::Surface surface =
        scene::flatten(scene, scene::NormalSource::patch, truth::TruthOptions{}.crease_rad);
    for (const glm::dvec3& p_world : surface.p_world) {
        counts.non_finite += scene::is_finite(p_world) ? 0 : 1;
        counts.non_finite += scene::is_finite(projection.to_clip(p_world)) ? 0 : 1;
    }
    for (const glm::vec3& n : surface.n_world)
        counts.non_finite += scene::is_finite(n) ? 0 : 1;
    using enum raster::DepthEncoding;
    for (const auto encoding : {inverse, linear, log, zbuffer24, zbuffer16, reversed_float})
        counts.add(count_planes(scene, view, encoding));
    return counts;
}

std::int64_t count_non_finite(const truth::Truth& truth) {
    std::int64_t count = 0;
    for (const truth::Curve& curve : truth.curves) {
        for (const truth::CurvePoint* point : {&curve.begin, &curve.end})
            count += scene::is_finite({point->x_px, point->y_px, point->w}) ? 0 : 1;
        count += std::isfinite(curve.deviation_rad) && std::isfinite(curve.view_angle_rad) ? 0 : 1;
        count += std::isnan(curve.gap) ? 1 : 0;
    }
    return count;
}

std::int64_t count_non_finite(const harness::Row& row) {
    std::int64_t count = 0;
    const std::optional<double> soft_f = row.soft ? row.soft->f() : std::nullopt;
    for (const std::optional<double>& share :
         {row.f_2px, row.precision_2px, row.recall_2px, soft_f})
        count += share && !(*share >= 0 && *share <= 1) ? 1 : 0;
    count += row.mean_width_px && !std::isfinite(*row.mean_width_px) ? 1 : 0;
    return count;
}

std::int64_t count_overflow(method::Method& method,
                            const method::MethodConfig& config,
                            const scene::Scene& scene,
                            const method::Frame& frame) {
    const std::optional<method::LinearCode> code = method.code();
    core::ParamValues settings = config.info->complete(config.settings);
    const auto overflow = settings.find("overflow");
    if (!code || overflow == settings.end() || !fits_its_bits(*code)) return 0;
    overflow->second = overflow->second == "wrap" ? "saturate" : "wrap";
    const auto other = config.info->make(settings);
    other->prepare(scene);
    other->pose(scene);
    const std::vector<method::Layer> own_layers = method.layers(frame);
    const std::vector<method::Layer> other_layers = other->layers(frame);
    const method::Layer* a = core::find_named(own_layers, "packed");
    const method::Layer* b = core::find_named(other_layers, "packed");
    if (a == nullptr || b == nullptr) return 0;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < a->rgb.size(); ++i)
        count += a->rgb.data()[i] == b->rgb.data()[i] ? 0 : 1;
    return count;
}

}  // namespace ink::studies
